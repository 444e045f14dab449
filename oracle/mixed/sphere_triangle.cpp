// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/sphere_triangle.h"

#include "geometry/validation.h"
#include "oracle/exact/shapes/contact_of_nearest.h"

namespace touchstone::oracle {
namespace {

template <class Number>
Truth<Contact> truth_sphere_triangle(const Sphere3<Number>& sphere, const Triangle3<Number>& triangle) {
  validation::validate_numbers("sphere", sphere), validation::validate_numbers("triangle", triangle);
  validation::validate("sphere", sphere);
  const NearestPair nearest =
      nearest_pair({exact(triangle.a), exact(triangle.b), exact(triangle.c)}, {exact(sphere.center)});
  return contact_of_nearest(nearest.squared_distance, {exact(sphere.radius)}, {{"weights", nearest.weights_of_a}});
}

}  // namespace

Truth<Contact> sphere_triangle(const Sphere3d& sphere, const Triangle3d& triangle) {
  return truth_sphere_triangle(sphere, triangle);
}

template <Exact Number>
Truth<Contact> sphere_triangle(const Sphere3<Number>& sphere, const Triangle3<Number>& triangle) {
  return truth_sphere_triangle(sphere, triangle);
}
template Truth<Contact> sphere_triangle(const Sphere3<Rational>&, const Triangle3<Rational>&);

}  // namespace touchstone::oracle
