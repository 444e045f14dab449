// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <array>

#include "simulate/world/arithmetic.h"
#include "simulate/world/scene.h"

/// Energy and momentum of a state as rationals: nothing is rounded.
namespace touchstone::simulate {

/// Kinetic energy (p. 66), height in gravity, and what springs hold (p. 72): k depth^2 / 2. Fixed bodies have none.
mpq_class energy(const Scene& scene, const State<Exact>& state);
/// p. 65.
std::array<mpq_class, 3> momentum(const Scene& scene, const State<Exact>& state);

/// Of one body.
mpq_class kinetic_energy(const mpq_class& mass, const Vector3<Exact>& velocity);

State<Exact> in_exact(const State<double>& state);

/// Where the change of energy in one step comes from. The parts add up to it exactly.
struct Drift {
  mpq_class law;       ///< what the contacts of the same step, nothing rounded, gain: a restitution below 1 loses
  mpq_class scheme;    ///< what that step gains more: gravity's scheme, contacts found late
  mpq_class decision;  ///< what that step gains more if it answers the contacts that the run answered
  mpq_class rounding;  ///< the rest: the run's numbers are rounded
  mpq_class own{};  ///< the rest of a foreign engine, which has a scheme of its own: for it, in place of the two before
  mpq_class total() const { return law + scheme + decision + rounding + own; }
  Drift& operator+=(const Drift& other) {
    law += other.law, scheme += other.scheme, decision += other.decision, rounding += other.rounding, own += other.own;
    return *this;
  }
};

}  // namespace touchstone::simulate
