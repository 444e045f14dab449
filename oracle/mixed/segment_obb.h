// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rays.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the least and the greatest t, 0 <= t <= 1, of the linear program in t and the coefficients of the half axes,
/// by which both give the same point; `none` where Farkas' lemma contradicts it. On integers.
///
/// Margin: a length, in the maximum norm, of displacements of the segment, as ray_obb.h has it.
///
/// Certificate: hit: none is needed ("passage"), the answer is checked alone. none: a `normal` along which all of the
/// segment is beyond the box ("separating_plane").
template <Exact Number = double>
Truth<Passage<Rational>> segment_obb(const Segment3<Number>& segment, const Obb3<Number>& obb);

}  // namespace touchstone::oracle
