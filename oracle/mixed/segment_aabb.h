// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rays.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the least and the greatest t of the linear program in t, 0 <= t <= 1 with the point in the box; `none` where
/// Farkas' lemma contradicts it. Margin: a length, how far the segment has to be moved in the maximum norm until the
/// relation changes. Certificate: hit: none is needed ("passage"), the answer is checked alone. none: a `normal` along
/// which all of the segment is beyond the box ("separating_plane").
template <Exact Number = double>
Truth<Passage<Rational>> segment_aabb(const Segment2<Number>& segment, const Aabb2<Number>& aabb);
template <Exact Number = double>
Truth<Passage<Rational>> segment_aabb(const Segment3<Number>& segment, const Aabb3<Number>& aabb);

}  // namespace touchstone::oracle
