// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/ray_sphere.h"

#include "geometry/validation.h"
#include "oracle/exact/shapes/passage.h"

namespace touchstone::oracle {
namespace {

template <class Ray, class Ball>
Truth<Passage<Surd>> truth_ray_sphere(const Ray& ray, const Ball& sphere) {
  validation::validate_all("ray", ray, "sphere", sphere);
  return passage_of_ball(line_of(ray), coordinates(sphere.center), exact(sphere.radius));
}

}  // namespace

template <Exact Number>
Truth<Passage<Surd>> ray_sphere(const Ray2<Number>& ray, const Circle2<Number>& sphere) {
  return truth_ray_sphere(ray, sphere);
}
template <Exact Number>
Truth<Passage<Surd>> ray_sphere(const Ray3<Number>& ray, const Sphere3<Number>& sphere) {
  return truth_ray_sphere(ray, sphere);
}
template Truth<Passage<Surd>> ray_sphere(const Ray2d&, const Circle2d&);
template Truth<Passage<Surd>> ray_sphere(const Ray3d&, const Sphere3d&);
template Truth<Passage<Surd>> ray_sphere(const Ray2<Rational>&, const Circle2<Rational>&);
template Truth<Passage<Surd>> ray_sphere(const Ray3<Rational>&, const Sphere3<Rational>&);

}  // namespace touchstone::oracle
