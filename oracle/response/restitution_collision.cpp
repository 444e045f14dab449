// SPDX-License-Identifier: Apache-2.0
#include "oracle/response/restitution_collision.h"

#include "oracle/exact/systems/impact.h"

namespace touchstone::oracle {
namespace {

template <class Number>
Truth<Velocities<Rational>> truth_restitution_collision(const Masses<Number>& masses,
                                                        const Velocities<Number>& velocities,
                                                        const Vector3<Number>& normal, const Number& e) {
  validation::validate_numbers("masses", masses), validation::validate_numbers("velocities", velocities),
      validation::validate_numbers("normal", normal), validation::validate_numbers("e", e),
      validation::validate("masses", masses), validation::validate("velocities", velocities),
      validation::validate("normal", normal, rule::normal), validation::validate("e", e, rule::restitution);
  return after_impact(masses, velocities, normal, exact(e));
}

}  // namespace

Truth<Velocities<Rational>> restitution_collision(const Massesd& masses, const Velocitiesd& velocities,
                                                  const Vector3d& normal, double e) {
  return truth_restitution_collision(masses, velocities, normal, e);
}

template <Exact Number>
Truth<Velocities<Rational>> restitution_collision(const Masses<Number>& masses, const Velocities<Number>& velocities,
                                                  const Vector3<Number>& normal, const Number& e) {
  return truth_restitution_collision(masses, velocities, normal, e);
}
template Truth<Velocities<Rational>> restitution_collision(const Masses<Rational>&, const Velocities<Rational>&,
                                                           const Vector3<Rational>&, const Rational&);

}  // namespace touchstone::oracle
