// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: with c and v the position and velocity of a as b sees them, f(t) = |c + t v|^2 - (ra + rb)^2, an integer
/// polynomial over the common scale. 0 if f(0) <= 0; otherwise Sturm's chain of f counts its zeros in (0, 1] by changes
/// of sign, and the first is the smaller root, an exact surd. Margin: the absolute value of the least f(t) of all t in
/// [0, 1], where the vertex of f or an end of the step is: a difference of squared lengths, the least squared distance
/// of the centers minus the squared sum of the radii. 0 for a sweep that is tangent, a touch at the start that parts, a
/// first contact at t = 1; not for a touch at the start that goes deeper, which no small change undoes.
template <Exact Number = double>
Truth<FirstContact<Surd>> swept_sphere_sphere(const Sphere3<Number>& a, const Sphere3<Number>& b,
                                              const Vector3<Number>& velocity_a, const Vector3<Number>& velocity_b);

}  // namespace touchstone::oracle
