// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a point that moves from start to end in one step hits the solid half-space normal . p + offset <= 0
/// of a plane.
///
/// Option 1 tests only the end of the step; option 2 finds the first t in [0, 1], counted in steps, and the point.
/// Touching is a hit; a start on the plane or behind it hits at t = 0; start == end is valid. Right for all finite
/// doubles in every floating-point environment, t and point correctly rounded. NaN and infinities throw InvalidInput,
/// which names the field and "finite number"; so does a normal of length 0 ("nonzero normal"). Contract:
/// reference/planes/point_plane_toi.h.
PointPlaneToi<double> point_plane_toi(const Plane3d& plane, const Point3d& start, const Point3d& end);

namespace stages {

/// The filter decides the steps that stay on one side of the plane, or start behind it: then there is no number to
/// compute.
struct point_plane_toi : Signatures<decltype(robust::point_plane_toi)> {
  static Partial filter, enclosed, lattice;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
