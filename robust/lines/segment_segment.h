// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/filters.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Finds the intersection of two closed segments: `disjoint`; `point`, with the point and both parameters, 0 at a
/// segment's a and 1 at its b; or `overlap`, the common segment with its ends in lexicographic order.
///
/// A touch in an end is a `point`, and so are collinear segments that share one point. A segment of length 0 is a
/// point, with parameter 0. Right for all finite doubles in every floating-point environment, and every number
/// correctly rounded. NaN and infinities throw InvalidInput, which names the field and "finite number". Contract:
/// reference/lines/segment_segment.h.
SegmentSegment<double> segment_segment(const Segment2d& a, const Segment2d& b);

/// The decision alone, which costs less.
inline SegmentRelation segment_segment_relation(const Segment2d& a, const Segment2d& b);

namespace stages {

struct segment_segment : Signatures<decltype(robust::segment_segment)> {
  static Partial enclosed, lattice;
  static Total exact;

  /// After this filter the boxes of the segments are compared, before the other stages.
  struct decision : Filtered<decision, decltype(robust::segment_segment_relation)> {
    static Perhaps<SegmentRelation> filter(const Segment2d& a, const Segment2d& b) {
      return filters::by_sign(filters::segments(a, b), SegmentRelation::disjoint, SegmentRelation::point);
    }
    static Partial lattice;
    static Total exact;
    static Staged past_filter;
  };
};

}  // namespace stages

inline SegmentRelation segment_segment_relation(const Segment2d& a, const Segment2d& b) {
  return stages::segment_segment::decision::ask(a, b).answer;
}

}  // namespace touchstone::robust
