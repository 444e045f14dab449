// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "robust/kernel/plane_filter.h"
#include "robust/kernel/staged.h"

namespace touchstone::robust {

/// Where a point lies of a plane, all points with normal . p + offset = 0: in `front`, to which the normal points, `on`
/// it or on its `back`; and its distance, which is negative on the back.
///
/// `on` means exactly on the plane. The normal may have any length but 0. Right for all finite doubles in every
/// floating-point environment, and the distance correctly rounded. NaN and infinities throw InvalidInput, which names
/// the field and "finite number"; so does a normal of length 0 ("nonzero normal"). Contract:
/// reference/planes/point_plane.h.
PointPlane<double> point_plane(const Plane3d& plane, const Point3d& point);

/// The decision alone, which costs less.
inline PlaneSide point_plane_side(const Plane3d& plane, const Point3d& point);

namespace detail {

struct point_plane_side : Filtered<point_plane_side, PlaneSide> {
  static Perhaps<PlaneSide> filter(const Plane3d& plane, const Point3d& point) {
    return filters::by_sign(filters::plane(plane, point), PlaneSide::front, PlaneSide::back);
  }
  static Decided<PlaneSide> past_filter(const Plane3d& plane, const Point3d& point);
};

}  // namespace detail

inline PlaneSide point_plane_side(const Plane3d& plane, const Point3d& point) {
  return detail::point_plane_side::ask(plane, point).answer;
}

}  // namespace touchstone::robust
