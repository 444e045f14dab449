// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "reference/lines/line_line.h"

namespace touchstone::reference {

/// Decides whether two closed segments meet, and where.
///
/// Deck p. 12-13: the lines through the segments, solved for ta and tb; the segments meet in the point where
///     0 <= ta <= 1 and 0 <= tb <= 1,
/// else (also where the lines are parallel) they are disjoint. a, b: any unit of length, the same for both; ta, tb:
/// pure numbers, 0 at the segment's a and 1 at its b. Closed sets: a touch in an end is a `point`. `overlap`: the
/// common segment, its ends in lexicographic order; collinear segments that share exactly one point meet in that
/// `point`. Degenerate: a segment of length 0 is a point, its parameter is 0. NaN or infinity: refused by robust and
/// oracle (field, "finite number").
///
/// The slide has no case for parallel lines: collinear segments that overlap or share an end, and segments of length 0,
/// are `disjoint` even in exact arithmetic (cause: algorithm); `overlap` is never answered.
///
/// Rounding: with D, e(D), e(ta) and e(tb) of reference/lines/line_line.h, the double version is right when |D| exceeds
/// e(D) and either ta or tb is outside [0, 1] by more than its own e, or both are inside and further than their e from
/// both 0 and 1, unless something overflows. The point and its parameters are then within the bounds given there. ulps:
/// 13 roundings behind ta and tb, 15 behind each coordinate of the point.
template <class Real>
SegmentSegment<Real> segment_segment(const Segment2<Real>& a, const Segment2<Real>& b) {
  const LineLine<Real> lines = line_line(Line2<Real>{a.a, a.b}, Line2<Real>{b.a, b.b});
  if (lines.relation == LineRelation::crossing && Real(0) <= *lines.ta && *lines.ta <= Real(1) &&
      Real(0) <= *lines.tb && *lines.tb <= Real(1)) {
    return {SegmentRelation::point, lines.ta, lines.tb, lines.point, std::nullopt};
  }
  return {SegmentRelation::disjoint, std::nullopt, std::nullopt, std::nullopt, std::nullopt};
}

}  // namespace touchstone::reference
