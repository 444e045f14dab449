// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/plane_filter.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides on which side of a plane, all points with normal . p + offset = 0, a point lies: in `front`, to which the
/// normal points, `on` it or on its `back`; and computes its distance, which is negative on the back.
///
/// `on` means exactly on the plane. The normal may have any length but 0. Right for all finite doubles in every
/// floating-point environment, and the distance correctly rounded. NaN and infinities throw InvalidInput, which names
/// the field and "finite number"; so does a normal of length 0 ("nonzero normal"). Contract:
/// reference/planes/point_plane.h.
PointPlane<double> point_plane(const Plane3d& plane, const Point3d& point);

/// The decision alone, which costs less.
inline PlaneSide point_plane_side(const Plane3d& plane, const Point3d& point);

namespace stages {

struct point_plane : Signatures<decltype(robust::point_plane)> {
  static Partial enclosed, lattice;
  static Total exact;

  struct decision : Filtered<decision, decltype(robust::point_plane_side)> {
    static Perhaps<PlaneSide> filter(const Plane3d& plane, const Point3d& point) {
      return filters::by_sign(filters::plane(plane, point), PlaneSide::front, PlaneSide::back);
    }
    static Partial lattice;
    static Total exact;
    static Staged past_filter;
  };
};

}  // namespace stages

inline PlaneSide point_plane_side(const Plane3d& plane, const Point3d& point) {
  return stages::point_plane::decision::ask(plane, point).answer;
}

}  // namespace touchstone::robust
