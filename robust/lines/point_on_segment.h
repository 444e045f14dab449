// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/answers.h"
#include "robust/kernel/filters.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/lines/point_on_segment.h. Right, and t correctly rounded, for all finite doubles in every
/// floating-point environment.
PointOnSegment<double> point_on_segment(const Point2d& point, const Segment2d& segment);

/// The decision alone; and which stage decided.
inline Incidence point_on_segment_relation(const Point2d& point, const Segment2d& segment);
inline Incidence point_on_segment_relation(const Point2d& point, const Segment2d& segment, Stage& decided);

/// The stages; robust/kernel/stage.h says what each may expect and answer.
inline std::optional<Incidence> point_on_segment_relation_filter(const Point2d& point, const Segment2d& segment);
std::optional<Incidence> point_on_segment_relation_lattice(const Point2d& point, const Segment2d& segment);
Incidence point_on_segment_relation_exact(const Point2d& point, const Segment2d& segment);
std::optional<PointOnSegment<double>> point_on_segment_lattice(const Point2d& point, const Segment2d& segment);
PointOnSegment<double> point_on_segment_exact(const Point2d& point, const Segment2d& segment);

/// Validation, then the stages after the filter.
Incidence point_on_segment_relation_past_filter(const Point2d& point, const Segment2d& segment, Stage& decided);

/// Knows only of points that are certainly off the line of the segment.
inline std::optional<Incidence> point_on_segment_relation_filter(const Point2d& point, const Segment2d& segment) {
  if (filters::orientation(segment.a, segment.b, point) == filters::Sign::unknown) return std::nullopt;
  return Incidence::off;
}

inline Incidence point_on_segment_relation(const Point2d& point, const Segment2d& segment, Stage& decided) {
  decided = Stage::filter;
  if (const auto answer = point_on_segment_relation_filter(point, segment)) return *answer;
  return point_on_segment_relation_past_filter(point, segment, decided);
}

inline Incidence point_on_segment_relation(const Point2d& point, const Segment2d& segment) {
  if (const auto answer = point_on_segment_relation_filter(point, segment)) return *answer;
  Stage ignored;
  return point_on_segment_relation_past_filter(point, segment, ignored);
}

}  // namespace touchstone::robust
