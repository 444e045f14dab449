// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/volumes/point_in_obb.h"

namespace touchstone::robust::stages {

struct point_in_obb : detail::point_in_obb {
  static Perhaps<Location> lattice(const Obb3d& obb, const Point3d& point);
  static Location exact(const Obb3d& obb, const Point3d& point);
};

}  // namespace touchstone::robust::stages
