// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/filters.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a point lies on a closed segment, both ends included: `on`, with t from 0 at segment.a to 1 at
/// segment.b, or `off`.
///
/// `on` means exactly on it. A segment of length 0 is the point a, with t 0. Right for all finite doubles in every
/// floating-point environment, and t correctly rounded. NaN and infinities throw InvalidInput, which names the field
/// and "finite number". Contract: reference/lines/point_on_segment.h.
PointOnSegment<double> point_on_segment(const Point2d& point, const Segment2d& segment);

/// The decision alone, which costs less.
inline Incidence point_on_segment_relation(const Point2d& point, const Segment2d& segment);

namespace stages {

struct point_on_segment : Signatures<decltype(robust::point_on_segment)> {
  static Partial lattice;
  static Total exact;

  /// The filter decides only points that are certainly off the line of the segment.
  struct decision : Filtered<decision, decltype(robust::point_on_segment_relation)> {
    static Perhaps<Incidence> filter(const Point2d& point, const Segment2d& segment) {
      return filters::by_sign(filters::orientation(segment.a, segment.b, point), Incidence::off, Incidence::off);
    }
    static Partial lattice;
    static Total exact;
    static Staged past_filter;
  };
};

}  // namespace stages

inline Incidence point_on_segment_relation(const Point2d& point, const Segment2d& segment) {
  return stages::point_on_segment::decision::ask(point, segment).answer;
}

}  // namespace touchstone::robust
