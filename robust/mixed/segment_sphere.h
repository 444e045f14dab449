// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "robust/kernel/filters/segments/segment_ball_filter.h"
#include "robust/kernel/solids/ball_passage.h"

namespace touchstone::robust {

/// Finds where a closed segment enters and leaves a ball, or in the plane a disc, as closed solids: `hit` with the
/// first and the last t, 0 at a and 1 at b; or `none`.
///
/// A tangent segment is a hit; radius 0 is a point. first is 0 if a is in the ball, last is 1 where b is; a segment of
/// length 0 is a point, both are 0. Right for all finite doubles in every floating-point environment, and both numbers
/// correctly rounded. NaN and infinities throw InvalidInput, which names the field and "finite number"; so does a
/// negative radius ("radius >= 0"). Contract: reference/mixed/segment_sphere.h.
inline Passage<double> segment_sphere(const Segment2d& segment, const Circle2d& sphere);
inline Passage<double> segment_sphere(const Segment3d& segment, const Sphere3d& sphere);

/// The decision alone, which costs less.
inline PassageRelation segment_sphere_relation(const Segment2d& segment, const Circle2d& sphere);
inline PassageRelation segment_sphere_relation(const Segment3d& segment, const Sphere3d& sphere);

namespace stages {

/// The filter decides segments that miss: then there is no number to compute.
struct segment_sphere : kernel::BallPassage {
  static Decided<Passage<double>> ask(const kernel::Line& segment, const kernel::Ball& sphere);

  struct decision : Filtered<decision> {
    static Perhaps<PassageRelation> filter(const auto& segment, const auto& sphere) {
      if (kernel::sign_bit(sphere.radius)) return std::nullopt;  // -0.0, or negative, which validation refuses
      const auto sign = filters::segment_meets_ball(segment.a, segment.b, sphere.center, sphere.radius);
      return filters::by_sign(sign, PassageRelation::hit, PassageRelation::none);
    }
    static PassageRelation exact(const kernel::Line& segment, const kernel::Ball& sphere);
    static Decided<PassageRelation> past_filter(const kernel::Line& segment, const kernel::Ball& sphere);
  };
};

}  // namespace stages

inline Passage<double> segment_sphere(const Segment2d& segment, const Circle2d& sphere) {
  return stages::segment_sphere::ask(segment, sphere).answer;
}
inline Passage<double> segment_sphere(const Segment3d& segment, const Sphere3d& sphere) {
  return stages::segment_sphere::ask(segment, sphere).answer;
}

inline PassageRelation segment_sphere_relation(const Segment2d& segment, const Circle2d& sphere) {
  return stages::segment_sphere::decision::ask(segment, sphere).answer;
}
inline PassageRelation segment_sphere_relation(const Segment3d& segment, const Sphere3d& sphere) {
  return stages::segment_sphere::decision::ask(segment, sphere).answer;
}

}  // namespace touchstone::robust
