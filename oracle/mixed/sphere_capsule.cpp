// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/sphere_capsule.h"

#include "geometry/validation.h"
#include "oracle/exact/shapes/contact_of_nearest.h"

namespace touchstone::oracle {
namespace {

template <class Number>
Truth<Contact> truth_sphere_capsule(const Sphere3<Number>& sphere, const Capsule3<Number>& capsule) {
  validation::validate_numbers("sphere", sphere), validation::validate_numbers("capsule", capsule);
  validation::validate("sphere", sphere), validation::validate("capsule", capsule);
  const auto& [a, b] = capsule.segment;
  const NearestPair nearest = nearest_pair({exact(a), exact(b)}, {exact(sphere.center)});
  return contact_of_nearest(nearest.squared_distance, {exact(sphere.radius), exact(capsule.radius)},
                            {{"weights", nearest.weights_of_a}});
}

}  // namespace

Truth<Contact> sphere_capsule(const Sphere3d& sphere, const Capsule3d& capsule) {
  return truth_sphere_capsule(sphere, capsule);
}

template <Exact Number>
Truth<Contact> sphere_capsule(const Sphere3<Number>& sphere, const Capsule3<Number>& capsule) {
  return truth_sphere_capsule(sphere, capsule);
}
template Truth<Contact> sphere_capsule(const Sphere3<Rational>&, const Capsule3<Rational>&);

}  // namespace touchstone::oracle
