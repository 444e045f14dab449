// SPDX-License-Identifier: Apache-2.0
#include "oracle/response/kinetic_energy.h"

#include <utility>

#include "oracle/exact/shapes/many_bodies.h"

namespace touchstone::oracle {
namespace {

/// In units of the list.
struct Centre {
  Integer mass;
  Vector3<Integer> momentum{};
  Rational of_mass, of_bodies;  ///< twice the energies

  explicit Centre(const ManyBodies& bodies) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      mass += bodies.mass(i);
      momentum = momentum + bodies.mass(i) * bodies.velocity(i);
    }
    if (bodies.size() == 0) return;
    Integer seen;  // times the squared mass
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const Vector3<Integer> v = mass * bodies.velocity(i) - momentum;
      seen += bodies.mass(i) * dot(v, v);
    }
    of_mass = Rational(dot(momentum, momentum), mass), of_bodies = Rational(seen, Integer(mass * mass));
    of_mass.canonicalize(), of_bodies.canonicalize();
  }
};

Certificate certificate(const ManyBodies& bodies, const Centre& centre) {
  const auto speed = [&](const Integer& momentum) {
    if (sgn(centre.mass) == 0) return Rational(0);
    return bodies.speeds.actual(Rational(Rational(momentum) / Rational(centre.mass)), 1);
  };
  const Vector3<Integer>& p = centre.momentum;
  return {"centre",
          {{"mass", {bodies.masses.actual(Rational(centre.mass), 1)}},
           {"velocity", {speed(p.x), speed(p.y), speed(p.z)}},
           {"doubled_energies", {bodies.actual(centre.of_mass, 2), bodies.actual(centre.of_bodies, 2)}}}};
}

Truth<Rational> truth_kinetic_energy(ManyBodies bodies) {
  Centre centre(bodies);
  Rational energy = bodies.actual(Rational((centre.of_mass + centre.of_bodies) / 2), 2);
  return {std::move(energy), std::nullopt,
          [bodies = std::move(bodies), centre = std::move(centre)] { return certificate(bodies, centre); }};
}

}  // namespace

template <Exact Number>
Truth<Rational> kinetic_energy(const std::vector<Body<Number>>& bodies) {
  return truth_kinetic_energy(ManyBodies(bodies));
}
template Truth<Rational> kinetic_energy(const std::vector<Bodyd>&);
template Truth<Rational> kinetic_energy(const std::vector<Body<Rational>>&);

}  // namespace touchstone::oracle
