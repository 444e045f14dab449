// SPDX-License-Identifier: Apache-2.0
#include "oracle/response/elastic_collision.h"

#include "oracle/exact/systems/impact.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Velocities<Rational>> elastic_collision(const Masses<Number>& masses, const Velocities<Number>& velocities,
                                              const Vector3<Number>& normal) {
  validation::validate_all("masses", masses, "velocities", velocities, "normal",
                           validation::under(rule::normal, normal));
  return after_impact(masses, velocities, normal, Rational(1));
}
template Truth<Velocities<Rational>> elastic_collision(const Massesd&, const Velocitiesd&, const Vector3d&);
template Truth<Velocities<Rational>> elastic_collision(const Masses<Rational>&, const Velocities<Rational>&,
                                                       const Vector3<Rational>&);

}  // namespace touchstone::oracle
