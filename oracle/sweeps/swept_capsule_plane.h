// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: that of swept_sphere_plane for the point of the segment that is nearest to the plane at the start, a point on
/// the plane if the segment has one (oracle/exact/shapes/half_space.h). Margin: as
/// reference/sweeps/swept_capsule_plane.h has it; not for what goes deeper after a touch, or through the plane.
template <Exact Number = double>
Truth<FirstContact<Surd>> swept_capsule_plane(const Capsule3<Number>& capsule, const Vector3<Number>& velocity,
                                              const Plane<Number>& plane);

}  // namespace touchstone::oracle
