// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/obb_filter.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a point lies inside of an oriented box, on its `boundary` or outside.
///
/// The half axes need not be perpendicular: the box is the parallelepiped that they span, exactly. Right for all finite
/// doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names the field and
/// "finite number"; so do half axes that are linearly dependent ("obb.half_axes", "linearly independent"). Contract:
/// reference/volumes/point_in_obb.h.
inline Location point_in_obb(const Obb3d& obb, const Point3d& point);

namespace stages {

struct point_in_obb : Filtered<point_in_obb, decltype(robust::point_in_obb)> {
  static Perhaps<Location> filter(const Obb3d& obb, const Point3d& point) {
    return filters::point_in_obb<double>(obb, point);
  }
  static Partial lattice;
  static Total exact;
  static Staged past_filter;
};

}  // namespace stages

inline Location point_in_obb(const Obb3d& obb, const Point3d& point) {
  return stages::point_in_obb::ask(obb, point).answer;
}

}  // namespace touchstone::robust
