// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/answers.h"
#include "robust/kernel/filters.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/lines/segment_segment.h. Right, and every number correctly rounded, for all finite doubles in
/// every floating-point environment.
SegmentSegment<double> segment_segment(const Segment2d& a, const Segment2d& b);

/// The decision alone; and which stage decided.
inline SegmentRelation segment_segment_relation(const Segment2d& a, const Segment2d& b);
inline SegmentRelation segment_segment_relation(const Segment2d& a, const Segment2d& b, Stage& decided);

/// The stages; robust/kernel/stage.h says what each may expect and answer. The filter first multiplies sides, then
/// compares the boxes of the segments.
inline std::optional<SegmentRelation> segment_segment_relation_filter(const Segment2d& a, const Segment2d& b);
std::optional<SegmentRelation> segment_segment_relation_lattice(const Segment2d& a, const Segment2d& b);
SegmentRelation segment_segment_relation_exact(const Segment2d& a, const Segment2d& b);
std::optional<SegmentSegment<double>> segment_segment_lattice(const Segment2d& a, const Segment2d& b);
SegmentSegment<double> segment_segment_exact(const Segment2d& a, const Segment2d& b);

/// What the arithmetic of the filter leaves open: validation, the filter's boxes, the other stages.
SegmentRelation segment_segment_relation_past_filter(const Segment2d& a, const Segment2d& b, Stage& decided);

/// Without a branch: nobody can predict whether segments cross.
inline SegmentRelation segment_segment_relation_for(filters::Sign certain) {
  static_assert(static_cast<int>(SegmentRelation::disjoint) == 0 && static_cast<int>(SegmentRelation::point) == 1);
  return static_cast<SegmentRelation>(certain == filters::Sign::negative);
}

inline std::optional<SegmentRelation> segment_segment_relation_filter(const Segment2d& a, const Segment2d& b) {
  const filters::Sign sign = filters::segments(a, b);
  if (sign != filters::Sign::unknown) return segment_segment_relation_for(sign);
  if (filters::apart(a, b)) return SegmentRelation::disjoint;
  return std::nullopt;
}

inline SegmentRelation segment_segment_relation(const Segment2d& a, const Segment2d& b, Stage& decided) {
  decided = Stage::filter;
  const filters::Sign sign = filters::segments(a, b);
  if (sign != filters::Sign::unknown) return segment_segment_relation_for(sign);
  return segment_segment_relation_past_filter(a, b, decided);
}

inline SegmentRelation segment_segment_relation(const Segment2d& a, const Segment2d& b) {
  const filters::Sign sign = filters::segments(a, b);
  if (sign != filters::Sign::unknown) return segment_segment_relation_for(sign);
  Stage ignored;
  return segment_segment_relation_past_filter(a, b, ignored);
}

}  // namespace touchstone::robust
