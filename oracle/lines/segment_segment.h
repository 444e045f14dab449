// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/certificates/certificate.h"

namespace touchstone::oracle {

/// Truth: the exact linear program over (ta, tb) in [0, 1]^2 with a(ta) = b(tb): its Farkas vector is a separating line, the
/// least and the greatest ta are the ends of what is common. (segment_segment_relation.h has a second, faster truth for the
/// relation alone, by elimination; the tests hold them equal.)
/// Margin: the least squared distance of an end of one segment from the other segment. For `disjoint` that is the squared
/// distance of the two segments, for a crossing it says how far the nearest end is from touching; 0 for every contact
/// at an end and for `overlap`.
Truth<SegmentSegment<Rational>> segment_segment(const Segment2d& a, const Segment2d& b);
Certificate segment_segment_certificate(const Segment2d& a, const Segment2d& b);

}  // namespace touchstone::oracle
