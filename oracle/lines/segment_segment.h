// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/exact/systems/elimination.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the exact linear program over (ta, tb) in [0, 1]^2 with a(ta) = b(tb): its Farkas vector is a separating
/// line, the least and the greatest ta are the ends of what is common. Margin: the least squared distance of an end of
/// one segment from the other segment. For `disjoint` that is the squared distance of the two segments, for a crossing
/// it says how far the nearest end is from touching; 0 for every contact at an end and for `overlap`.
template <Exact Number = double>
Truth<SegmentSegment<Rational>> segment_segment(const Segment2<Number>& a, const Segment2<Number>& b);

/// The relation alone, by another method: elimination (oracle/exact/systems/elimination.h), in 128-bit integers if the
/// coordinates allow it. A second truth, several times faster; the tests hold it equal to the linear program.
SegmentRelation segment_segment_relation(const Segment2d& a, const Segment2d& b);

}  // namespace touchstone::oracle
