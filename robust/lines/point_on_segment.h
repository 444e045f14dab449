// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "robust/kernel/filters.h"
#include "robust/kernel/staged.h"

namespace touchstone::robust {

/// Whether a point lies on a closed segment, both ends included: `on`, with t from 0 at segment.a to 1 at segment.b, or
/// `off`.
///
/// `on` means exactly on it. A segment of length 0 is the point a, with t 0. Right for all finite doubles in every
/// floating-point environment, and t correctly rounded. NaN and infinities throw InvalidInput, which names the field
/// and "finite number". Contract: reference/lines/point_on_segment.h.
PointOnSegment<double> point_on_segment(const Point2d& point, const Segment2d& segment);

/// The decision alone, which costs less.
inline Incidence point_on_segment_relation(const Point2d& point, const Segment2d& segment);

namespace detail {

/// The filter knows only of points that are certainly off the line of the segment.
struct point_on_segment_relation : Filtered<point_on_segment_relation, Incidence> {
  static Perhaps<Incidence> filter(const Point2d& point, const Segment2d& segment) {
    return filters::by_sign(filters::orientation(segment.a, segment.b, point), Incidence::off, Incidence::off);
  }
  static Decided<Incidence> past_filter(const Point2d& point, const Segment2d& segment);
};

}  // namespace detail

inline Incidence point_on_segment_relation(const Point2d& point, const Segment2d& segment) {
  return detail::point_on_segment_relation::ask(point, segment).answer;
}

}  // namespace touchstone::robust
