// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The slabs of a k-DOP around points: for each normal N, in order, the least interval of doubles that contains N . P
/// of every point P, exactly. So no point is lost, and no narrower slab of doubles is right.
///
/// An end beyond the range is the greatest double, or the infinity if nothing else is outside. Right for all finite
/// doubles in every floating-point environment; 0 is returned as 0.0. NaN and infinities throw InvalidInput, which
/// names the field and "finite number"; so do an empty list of points ("at least 1 point") or normals ("at least 1
/// normal") and a normal of length 0 ("nonzero normal"). Contract: reference/volumes/kdop_of_points.h.
std::vector<Slabd> kdop_of_points(const std::vector<Point3d>& points, const std::vector<Vector3d>& normals);

namespace stages {

/// The lattice takes the points that doubles do not exclude as extremes; exact takes all.
struct kdop_of_points : Signatures<decltype(robust::kdop_of_points)> {
  static Partial lattice;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
