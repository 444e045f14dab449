// SPDX-License-Identifier: Apache-2.0
#include "robust/response/reflect_wall.h"

namespace touchstone::robust {

Vector3d reflect_wall(const Vector3d& velocity, Axis axis, Stage& decided) {
  decided = Stage::filter;
  return reflect_wall(velocity, axis);
}

}  // namespace touchstone::robust
