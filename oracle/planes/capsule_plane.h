// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the lower end of the segment, and the point of the half-space that is nearest to it, in rationals
/// (oracle/exact/shapes/half_space.h); the squared distance of both against that of the radius.
///
/// Margin: |S - r^2|, S being the squared distance: 0 for a tangent capsule, and for a segment that meets the
/// half-space.
///
/// Certificate, with the `weights` of the ends, which give the lowest point of the segment, and a `point` of the
/// half-space: disjoint: "nearest_point" (farther from that than the radius). touching: "tangent" (as far as the
/// radius). overlapping: "common_interior_point".
template <Exact Number = double>
Truth<Contact> capsule_plane(const Capsule3<Number>& capsule, const Plane<Number>& plane);

}  // namespace touchstone::oracle
