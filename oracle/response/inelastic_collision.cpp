// SPDX-License-Identifier: Apache-2.0
#include "oracle/response/inelastic_collision.h"

#include <utility>

#include "oracle/exact/systems/impact.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Vector3<Rational>> inelastic_collision(const Masses<Number>& masses, const Velocities<Number>& velocities) {
  validation::validate_all("masses", masses, "velocities", velocities);
  Rational mass(exact(masses.first) + exact(masses.second));
  const Rational part(exact(masses.second) / mass);
  const Vector3<Rational> v = exact_vector(velocities.first), w = exact_vector(velocities.second);
  Vector3<Rational> together = v + part * (w - v);
  return {together, std::nullopt, [mass = std::move(mass), together] {
            return Certificate{"momentum", {{"momentum", listed(mass * together)}}};
          }};
}
template Truth<Vector3<Rational>> inelastic_collision(const Massesd&, const Velocitiesd&);
template Truth<Vector3<Rational>> inelastic_collision(const Masses<Rational>&, const Velocities<Rational>&);

}  // namespace touchstone::oracle
