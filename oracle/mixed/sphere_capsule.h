// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the point of the segment that is nearest to the center, by the conditions of Karush, Kuhn and Tucker in
/// rationals (oracle/exact/shapes/nearest_pair.h); its squared distance against that of the sum of the radii.
///
/// Margin: |S - R^2|, S being the squared distance and R the sum; where they meet, also R^2 less the square of either
/// radius: 0 for tangent solids, and where a radius is 0 and they meet.
///
/// Certificate: disjoint: "nearest_points" (`weights` of the segment's ends, which give the nearest point; it is
/// farther than the sum of the radii). touching: "tangent" (as far as that) or "no_interior" (a radius is 0).
/// overlapping: "near_points" (nearer than that).
template <Exact Number = double>
Truth<Contact> sphere_capsule(const Sphere3<Number>& sphere, const Capsule3<Number>& capsule);

}  // namespace touchstone::oracle
