// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: points of the segment and the box that are nearest to each other, by the conditions of Karush, Kuhn and
/// Tucker in rationals (oracle/exact/shapes/round_solid.h); their squared distance against that of the radius.
///
/// Margin: |S - r^2|, S being the squared distance; where they meet, also the square of the box's least width: 0 for a
/// tangent capsule, for a segment that meets the box, and for a flat box that is met.
///
/// Certificate: as that of capsule_capsule, with `on_a`, weights of the segment's ends, and `on_b`, the point of the
/// box. A flat box has no interior either.
template <Exact Number = double>
Truth<Contact> capsule_aabb(const Capsule3<Number>& capsule, const Aabb3<Number>& aabb);

}  // namespace touchstone::oracle
