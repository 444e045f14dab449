// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/capsules.h"
#include "geometry/rays.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: f(t), the squared distance from the capsule's segment minus the squared radius, is convex, and rational in
/// three pieces at most, in which an end or the line of the segment is the nearest; changes of sign count the zeros of
/// each, forwards and backwards, and the first and the last are roots of theirs. Margin: |f(t)| where it is least.
///
/// Certificate: hit: none is needed ("passage"), the answer is checked alone. none: a `normal` along which all of the
/// ray is beyond the capsule ("separating_plane").
template <Exact Number = double>
Truth<Passage<Surd>> ray_capsule(const Ray3<Number>& ray, const Capsule3<Number>& capsule);

}  // namespace touchstone::oracle
