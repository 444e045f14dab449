// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/answers.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/lines/ray_segment.h. Right, and every number correctly rounded, for all finite doubles in every
/// floating-point environment.
RaySegment<double> ray_segment(const Ray2d& ray, const Segment2d& segment);

/// The decision alone; and which stage decided.
inline RayRelation ray_segment_relation(const Ray2d& ray, const Segment2d& segment);
inline RayRelation ray_segment_relation(const Ray2d& ray, const Segment2d& segment, Stage& decided);

/// The stages; robust/kernel/stage.h says what each may expect and answer.
std::optional<RayRelation> ray_segment_relation_lattice(const Ray2d& ray, const Segment2d& segment);
RayRelation ray_segment_relation_exact(const Ray2d& ray, const Segment2d& segment);
std::optional<RaySegment<double>> ray_segment_lattice(const Ray2d& ray, const Segment2d& segment);
RaySegment<double> ray_segment_exact(const Ray2d& ray, const Segment2d& segment);

/// The door, then the stages after the filter.
RayRelation ray_segment_relation_past_filter(const Ray2d& ray, const Segment2d& segment, Stage& decided);

inline RayRelation ray_segment_relation(const Ray2d& ray, const Segment2d& segment, Stage& decided) {
  return ray_segment_relation_past_filter(ray, segment, decided);
}

inline RayRelation ray_segment_relation(const Ray2d& ray, const Segment2d& segment) {
  Stage ignored;
  return ray_segment_relation_past_filter(ray, segment, ignored);
}

}  // namespace touchstone::robust
