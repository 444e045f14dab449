// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: points of both segments that are nearest to each other, by the conditions of Karush, Kuhn and Tucker in
/// rationals (oracle/exact/shapes/nearest_pair.h); their squared distance against that of the sum of the radii.
///
/// Margin: |S - R^2|, S being the squared distance and R the sum; where they meet, also R^2 less the square of either
/// radius: 0 for tangent capsules, and where a radius is 0 and they meet.
///
/// Certificate: disjoint: "nearest_points" (`on_a` and `on_b`, weights of the ends, which give the nearest points; they
/// are farther from each other than the sum of the radii). touching: "tangent" (as far as that) or "no_interior" (a
/// radius is 0). overlapping: "near_points" (nearer than that).
template <Exact Number = double>
Truth<Contact> capsule_capsule(const Capsule3<Number>& a, const Capsule3<Number>& b);

}  // namespace touchstone::oracle
