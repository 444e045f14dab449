// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "robust/kernel/filters/passage_filter.h"
#include "robust/kernel/solids/box_passage.h"

namespace touchstone::robust {

/// Finds where a ray enters and leaves an axis-aligned box, in the plane and in space: `hit` with the first and the
/// last t, in units of the direction's length; or `none`.
///
/// Touching is a hit, grazing along a face too; flat boxes are valid; zeros in the direction are no special case. first
/// is 0 if the origin is in the box. Right for all finite doubles in every floating-point environment, and both numbers
/// correctly rounded. NaN and infinities throw InvalidInput, which names the field and "finite number"; so do a
/// direction of length 0 ("nonzero direction") and min > max ("min <= max"). Contract: reference/mixed/ray_aabb.h.
inline Passage<double> ray_aabb(const Ray2d& ray, const Aabb2d& aabb);
inline Passage<double> ray_aabb(const Ray3d& ray, const Aabb3d& aabb);

/// The decision alone, which costs less.
inline PassageRelation ray_aabb_relation(const Ray2d& ray, const Aabb2d& aabb);
inline PassageRelation ray_aabb_relation(const Ray3d& ray, const Aabb3d& aabb);

namespace stages {

/// The filter decides rays that miss: then there is no number to compute.
struct ray_aabb : kernel::BoxPassage {
  static Decided<Passage<double>> ask(const kernel::Line& ray, const kernel::Box& aabb);

  struct decision : Filtered<decision> {
    static Perhaps<PassageRelation> filter(const kernel::Line& ray, const kernel::Box& aabb) {
      return filters::box_relation(ray, aabb);
    }
    static Perhaps<PassageRelation> lattice(const kernel::Line& ray, const kernel::Box& aabb);
    static PassageRelation exact(const kernel::Line& ray, const kernel::Box& aabb);
    static Decided<PassageRelation> past_filter(const kernel::Line& ray, const kernel::Box& aabb);
  };
};

}  // namespace stages

inline Passage<double> ray_aabb(const Ray2d& ray, const Aabb2d& aabb) {
  return stages::ray_aabb::ask(ray, aabb).answer;
}
inline Passage<double> ray_aabb(const Ray3d& ray, const Aabb3d& aabb) {
  return stages::ray_aabb::ask(ray, aabb).answer;
}

inline PassageRelation ray_aabb_relation(const Ray2d& ray, const Aabb2d& aabb) {
  return stages::ray_aabb::decision::ask(ray, aabb).answer;
}
inline PassageRelation ray_aabb_relation(const Ray3d& ray, const Aabb3d& aabb) {
  return stages::ray_aabb::decision::ask(ray, aabb).answer;
}

}  // namespace touchstone::robust
