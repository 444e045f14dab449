// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "robust/kernel/obb_filter.h"
#include "robust/kernel/staged.h"

namespace touchstone::robust {

/// Whether a point lies inside of an oriented box, on its `boundary` or outside.
///
/// The half axes need not be at right angles to each other: the box is the parallelepiped that they make, exactly.
/// Right for all finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names
/// the field and "finite number"; so do half axes that are linearly dependent ("obb.half_axes", "linearly
/// independent"). Contract: reference/volumes/point_in_obb.h.
inline Location point_in_obb(const Obb3d& obb, const Point3d& point);

namespace detail {

struct point_in_obb : Filtered<point_in_obb, Location> {
  static Perhaps<Location> filter(const Obb3d& obb, const Point3d& point) {
    return filters::point_in_obb<double>(obb, point);
  }
  static Decided<Location> past_filter(const Obb3d& obb, const Point3d& point);
};

}  // namespace detail

inline Location point_in_obb(const Obb3d& obb, const Point3d& point) {
  return detail::point_in_obb::ask(obb, point).answer;
}

}  // namespace touchstone::robust
