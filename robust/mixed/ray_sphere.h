// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "robust/kernel/filters/decode.h"
#include "robust/kernel/filters/ray_filter.h"
#include "robust/kernel/solids/ball_passage.h"

namespace touchstone::robust {

/// Finds where a ray enters and leaves a ball, or in the plane a disc, as closed solids: `hit` with the first and the
/// last t, in units of the direction's length; or `none`.
///
/// A tangent ray is a hit; radius 0 is a point. first is 0 if the origin is in the ball. Right for all finite doubles
/// in every floating-point environment, and both numbers correctly rounded. NaN and infinities throw InvalidInput,
/// which names the field and "finite number"; so do a direction of length 0 ("nonzero direction") and a negative radius
/// ("radius >= 0"). Contract: reference/mixed/ray_sphere.h.
inline Passage<double> ray_sphere(const Ray2d& ray, const Circle2d& sphere);
inline Passage<double> ray_sphere(const Ray3d& ray, const Sphere3d& sphere);

/// The decision alone, which costs less.
inline PassageRelation ray_sphere_relation(const Ray2d& ray, const Circle2d& sphere);
inline PassageRelation ray_sphere_relation(const Ray3d& ray, const Sphere3d& sphere);

namespace stages {

/// The filter decides rays that miss: then there is no number to compute.
struct ray_sphere : kernel::BallPassage {
  static Decided<Passage<double>> ask(const kernel::Line& ray, const kernel::Ball& sphere);

  struct decision : Filtered<decision> {
    static Perhaps<PassageRelation> filter(const kernel::Line& ray, const kernel::Ball& sphere) {
      if (kernel::sign_bit(sphere.radius)) return std::nullopt;  // -0.0, or negative, which validation refuses
      const filters::RayAndBall<double> both(ray.from, {ray.to.x, ray.to.y, ray.to.z}, sphere);
      return filters::by_sign(both.meets(), PassageRelation::hit, PassageRelation::none);
    }
    static PassageRelation exact(const kernel::Line& ray, const kernel::Ball& sphere);
    static Decided<PassageRelation> past_filter(const kernel::Line& ray, const kernel::Ball& sphere);
  };
};

}  // namespace stages

inline Passage<double> ray_sphere(const Ray2d& ray, const Circle2d& sphere) {
  return stages::ray_sphere::ask(ray, sphere).answer;
}
inline Passage<double> ray_sphere(const Ray3d& ray, const Sphere3d& sphere) {
  return stages::ray_sphere::ask(ray, sphere).answer;
}

inline PassageRelation ray_sphere_relation(const Ray2d& ray, const Circle2d& sphere) {
  return stages::ray_sphere::decision::ask(ray, sphere).answer;
}
inline PassageRelation ray_sphere_relation(const Ray3d& ray, const Sphere3d& sphere) {
  return stages::ray_sphere::decision::ask(ray, sphere).answer;
}

}  // namespace touchstone::robust
