// SPDX-License-Identifier: Apache-2.0
#include "oracle/response/inelastic_collision.h"

#include "oracle/exact/impact.h"

namespace touchstone::oracle {
namespace {

template <class Number>
Truth<Vector3<Rational>> truth(const Masses<Number>& masses, const Velocities<Number>& velocities) {
  validation::validate("masses", masses), validation::validate("velocities", velocities);
  const Rational m1 = exact(masses.first), m2 = exact(masses.second), part = Rational(m2 / Rational(m1 + m2));
  const Vector3<Rational> v = exact_vector(velocities.first), w = exact_vector(velocities.second);
  return {v + part * (w - v), std::nullopt};
}

}  // namespace

Truth<Vector3<Rational>> inelastic_collision(const Massesd& masses, const Velocitiesd& velocities) {
  return truth(masses, velocities);
}

template <Exact Number>
Truth<Vector3<Rational>> inelastic_collision(const Masses<Number>& masses, const Velocities<Number>& velocities) {
  return truth(masses, velocities);
}
template Truth<Vector3<Rational>> inelastic_collision(const Masses<Rational>&, const Velocities<Rational>&);

Certificate inelastic_collision_certificate(const Massesd& masses, const Velocitiesd& velocities) {
  const Vector3<Rational> together = truth(masses, velocities).answer;
  return {"momentum", {{"momentum", listed(Rational(exact(masses.first) + exact(masses.second)) * together)}}};
}

}  // namespace touchstone::oracle
