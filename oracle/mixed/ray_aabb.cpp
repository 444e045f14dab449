// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/ray_aabb.h"

#include "geometry/validation.h"
#include "oracle/exact/shapes/passage.h"

namespace touchstone::oracle {
namespace {

template <class Ray, class Box>
Truth<Passage<Rational>> truth_ray_aabb(const Ray& ray, const Box& aabb) {
  validation::validate_all("ray", ray, "aabb", aabb);
  return passage_of_box(line_of(ray), coordinates(aabb.min), coordinates(aabb.max));
}

}  // namespace

template <Exact Number>
Truth<Passage<Rational>> ray_aabb(const Ray2<Number>& ray, const Aabb2<Number>& aabb) {
  return truth_ray_aabb(ray, aabb);
}
template <Exact Number>
Truth<Passage<Rational>> ray_aabb(const Ray3<Number>& ray, const Aabb3<Number>& aabb) {
  return truth_ray_aabb(ray, aabb);
}
template Truth<Passage<Rational>> ray_aabb(const Ray2d&, const Aabb2d&);
template Truth<Passage<Rational>> ray_aabb(const Ray3d&, const Aabb3d&);
template Truth<Passage<Rational>> ray_aabb(const Ray2<Rational>&, const Aabb2<Rational>&);
template Truth<Passage<Rational>> ray_aabb(const Ray3<Rational>&, const Aabb3<Rational>&);

}  // namespace touchstone::oracle
