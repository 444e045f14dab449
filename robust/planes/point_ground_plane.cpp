// SPDX-License-Identifier: Apache-2.0
#include "robust/planes/point_ground_plane.h"

namespace touchstone::robust {

Height point_ground_plane(const Point3d& point, Stage& decided) {
  decided = Stage::filter;
  return point_ground_plane(point);
}

}  // namespace touchstone::robust
