// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: with E(t) = N . (center + t velocity) + d, ball and plane meet where f(t) = E(t)^2 - r^2 N . N <= 0; f is a
/// parabola, whose first zero is found by Sturm's chain (parabola.h). Margin: as reference/sweeps/swept_sphere_plane.h
/// has it, a difference of squared lengths; not for what goes deeper after a touch, or through the plane.
template <Exact Number = double>
Truth<FirstContact<Surd>> swept_sphere_plane(const Sphere3<Number>& sphere, const Vector3<Number>& velocity,
                                             const Plane<Number>& plane);

}  // namespace touchstone::oracle
