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
/// Margin: |S - r^2|, S being the squared distance: 0 for a tangent capsule, and for a segment that meets the box.
///
/// Certificate: as that of sphere_obb, with `on_a`, weights of the segment's ends, and `on_b`, coefficients.
template <Exact Number = double>
Truth<Contact> capsule_obb(const Capsule3<Number>& capsule, const Obb3<Number>& obb);

}  // namespace touchstone::oracle
