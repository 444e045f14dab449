// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/lines/segment_segment.h"

namespace touchstone::robust::stages {

struct segment_segment {
  static Perhaps<SegmentSegment<double>> enclosed(const Segment2d& a, const Segment2d& b);
  static Perhaps<SegmentSegment<double>> lattice(const Segment2d& a, const Segment2d& b);
  static SegmentSegment<double> exact(const Segment2d& a, const Segment2d& b);

  struct decision : detail::segment_segment_relation {
    /// The boxes included.
    static Perhaps<SegmentRelation> filter(const Segment2d& a, const Segment2d& b);
    static Perhaps<SegmentRelation> lattice(const Segment2d& a, const Segment2d& b);
    static SegmentRelation exact(const Segment2d& a, const Segment2d& b);
  };
};

}  // namespace touchstone::robust::stages
