// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rays.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the least and the greatest t of the linear program in t and the coefficients of the half axes, by which both
/// give the same point; `none` where Farkas' lemma contradicts it. On integers.
///
/// Margin: a length, in the maximum norm, of displacements of the ray. Those with which it meets the box make a solid
/// whose faces are spanned by two half axes, or by one and the direction: hit: how far it has to be moved to the
/// nearest of their planes, where it grazes the box; none: to the farthest of those that are between (so no less brings
/// it to the box).
///
/// Certificate: hit: none is needed ("passage"), the answer is checked alone. none: a `normal` along which all of the
/// ray is beyond the box ("separating_plane").
template <Exact Number = double>
Truth<Passage<Rational>> ray_obb(const Ray3<Number>& ray, const Obb3<Number>& obb);

}  // namespace touchstone::oracle
