// SPDX-License-Identifier: Apache-2.0
#include "oracle/response/restitution_collision.h"

#include "oracle/exact/systems/impact.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Velocities<Rational>> restitution_collision(const Masses<Number>& masses, const Velocities<Number>& velocities,
                                                  const Vector3<Number>& normal, const Number& e) {
  validation::validate_all("masses", masses, "velocities", velocities, "normal",
                           validation::under(rule::normal, normal), "e", validation::under(rule::restitution, e));
  return after_impact(masses, velocities, normal, exact(e));
}
template Truth<Velocities<Rational>> restitution_collision(const Massesd&, const Velocitiesd&, const Vector3d&,
                                                           const double&);
template Truth<Velocities<Rational>> restitution_collision(const Masses<Rational>&, const Velocities<Rational>&,
                                                           const Vector3<Rational>&, const Rational&);

}  // namespace touchstone::oracle
