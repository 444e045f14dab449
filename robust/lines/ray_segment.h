// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/answers.h"
#include "robust/kernel/filters.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/lines/ray_segment.h. Right, and every number correctly rounded, for all finite doubles in every
/// floating-point environment.
RaySegment<double> ray_segment(const Ray2d& ray, const Segment2d& segment);

/// The decision alone; and which stage decided.
inline RayRelation ray_segment_relation(const Ray2d& ray, const Segment2d& segment);
inline RayRelation ray_segment_relation(const Ray2d& ray, const Segment2d& segment, Stage& decided);

/// The stages; robust/kernel/stage.h says what each may expect and answer.
inline std::optional<RayRelation> ray_segment_relation_filter(const Ray2d& ray, const Segment2d& segment);
std::optional<RayRelation> ray_segment_relation_lattice(const Ray2d& ray, const Segment2d& segment);
RayRelation ray_segment_relation_exact(const Ray2d& ray, const Segment2d& segment);
std::optional<RaySegment<double>> ray_segment_lattice(const Ray2d& ray, const Segment2d& segment);
RaySegment<double> ray_segment_exact(const Ray2d& ray, const Segment2d& segment);

/// Validation, then the stages after the filter.
RayRelation ray_segment_relation_past_filter(const Ray2d& ray, const Segment2d& segment, Stage& decided);

/// Without a branch: nobody can predict whether a ray meets a segment.
inline RayRelation ray_segment_relation_for(filters::Sign certain) {
  static_assert(static_cast<int>(RayRelation::none) == 0 && static_cast<int>(RayRelation::point) == 1);
  return static_cast<RayRelation>(certain == filters::Sign::negative);
}

inline std::optional<RayRelation> ray_segment_relation_filter(const Ray2d& ray, const Segment2d& segment) {
  const filters::Sign sign = filters::ray(ray.origin, ray.direction, segment);
  if (sign == filters::Sign::unknown) return std::nullopt;
  return ray_segment_relation_for(sign);
}

inline RayRelation ray_segment_relation(const Ray2d& ray, const Segment2d& segment, Stage& decided) {
  decided = Stage::filter;
  if (const auto answer = ray_segment_relation_filter(ray, segment)) return *answer;
  return ray_segment_relation_past_filter(ray, segment, decided);
}

inline RayRelation ray_segment_relation(const Ray2d& ray, const Segment2d& segment) {
  const filters::Sign sign = filters::ray(ray.origin, ray.direction, segment);
  if (sign != filters::Sign::unknown) return ray_segment_relation_for(sign);
  Stage ignored;
  return ray_segment_relation_past_filter(ray, segment, ignored);
}

}  // namespace touchstone::robust
