// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the least t of the linear program in t and the coefficients of half axes, each in [-1, 1], that give the same
/// point of a, moved by t velocity, and of b; `never` where there is none.
///
/// Margin: a squared length. The displacements from points that a sweeps over to points of b make a solid of which the
/// edges are the half axes of both and the velocity (zonotope.h), around the way from the middle of a's path to b's
/// center; they meet if the origin is in it. Where it is, how far it is from the nearest plane of a face, otherwise how
/// far beyond the farthest.
///
/// Certificate: hit: a common `point` at t, and unless t is 0 ("start") a `normal` along which a touches b then and
/// approaches it ("first_contact"). never: a `normal` along which a is before b at the start and at the end
/// ("separating_axis"), that of the farthest plane.
template <Exact Number = double>
Truth<FirstContact<Rational>> swept_obb_obb(const Obb3<Number>& a, const Obb3<Number>& b,
                                            const Vector3<Number>& velocity);

}  // namespace touchstone::oracle
