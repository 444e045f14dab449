// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/volumes/point_in_kdop.h"

namespace touchstone::robust::stages {

/// Each stage for all slabs together; a slab that excludes the point decides alone.
struct point_in_kdop {
  static Perhaps<Location> filter(const Kdop3d& kdop, const Point3d& point);
  static Perhaps<Location> lattice(const Kdop3d& kdop, const Point3d& point);
  static Location exact(const Kdop3d& kdop, const Point3d& point);
  static Decided<Location> ask(const Kdop3d& kdop, const Point3d& point);
};

}  // namespace touchstone::robust::stages
