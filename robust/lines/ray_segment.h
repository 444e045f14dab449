// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/filters.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a ray meets a closed segment, and where first: `none`; `point`, with t and the point; or `overlap`,
/// a common segment with its ends in order of t, and t of the first. t >= 0 is in units of the direction's length.
///
/// The ray's origin and both ends of the segment belong to them, so a touch is a `point`; a segment of length 0 is a
/// point. Right for all finite doubles in every floating-point environment, and every number correctly rounded. NaN and
/// infinities throw InvalidInput, which names the field and "finite number"; so does a direction of length 0 ("nonzero
/// direction"). Contract: reference/lines/ray_segment.h.
RaySegment<double> ray_segment(const Ray2d& ray, const Segment2d& segment);

/// The decision alone, which costs less.
inline RayRelation ray_segment_relation(const Ray2d& ray, const Segment2d& segment);

namespace stages {

struct ray_segment : Signatures<decltype(robust::ray_segment)> {
  static Partial enclosed, lattice;
  static Total exact;

  struct decision : Filtered<decision, decltype(robust::ray_segment_relation)> {
    static Perhaps<RayRelation> filter(const Ray2d& ray, const Segment2d& segment) {
      return filters::by_sign(filters::ray(ray.origin, ray.direction, segment), RayRelation::none, RayRelation::point);
    }
    static Partial lattice;
    static Total exact;
    static Staged past_filter;
  };
};

}  // namespace stages

inline RayRelation ray_segment_relation(const Ray2d& ray, const Segment2d& segment) {
  return stages::ray_segment::decision::ask(ray, segment).answer;
}

}  // namespace touchstone::robust
