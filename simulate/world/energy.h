// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <array>

#include "simulate/world/arithmetic.h"
#include "simulate/world/scene.h"

/// Energy and momentum of a state as rationals: nothing is rounded.
namespace touchstone::simulate {

/// Kinetic energy (p. 66), potential energy in gravity, and the energy of springs (p. 72): k depth^2 / 2. Fixed bodies
/// have none.
mpq_class energy(const Scene& scene, const State<Exact>& state);
/// p. 65.
std::array<mpq_class, 3> momentum(const Scene& scene, const State<Exact>& state);

/// The kinetic energy of one body.
mpq_class kinetic_energy(const mpq_class& mass, const Vector3<Exact>& velocity);

State<Exact> in_exact(const State<double>& state);

/// The sources of the change of energy in one step. They add up to it exactly.
struct Drift {
  mpq_class law;       ///< what the contacts of the same step, nothing rounded, gain: a restitution below 1 loses
  mpq_class scheme;    ///< the further gain of that step: gravity's scheme, contacts found late
  mpq_class decision;  ///< the further gain of that step if it answers the contacts of the run
  mpq_class rounding;  ///< the rest: the run's numbers are rounded
  mpq_class own{};     ///< for a foreign engine, which has its own scheme: the rest, in place of the two before
  mpq_class total() const { return law + scheme + decision + rounding + own; }
  Drift& operator+=(const Drift& other) {
    law += other.law, scheme += other.scheme, decision += other.decision, rounding += other.rounding, own += other.own;
    return *this;
  }
};

}  // namespace touchstone::simulate
