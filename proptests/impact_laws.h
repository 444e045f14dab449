// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bodies.h"
#include "proptests/response_laws.h"

/// Laws of two bodies, as identities over rationals. A question is masses, velocities, and whatever follows.
namespace touchstone::proptests {

using ExactMasses = Masses<Rational>;
using ExactVelocities = Velocities<Rational>;

inline Motion3 momentum_of(const ExactMasses& m, const ExactVelocities& v) {
  return m.first * v.first + m.second * v.second;
}
inline Rational doubled_energy(const ExactMasses& m, const ExactVelocities& v) {
  return Rational(m.first * dot(v.first, v.first) + m.second * dot(v.second, v.second));
}
inline ExactVelocities with(const ExactVelocities& v, const Motion3& shift) {
  return {v.first + shift, v.second + shift};
}
inline bool same(const ExactVelocities& v, const ExactVelocities& w) {
  return same(v.first, w.first) && same(v.second, w.second);
}
/// The velocity of another observer.
inline Motion3 a_shift() { return {Rational(7, 3), Rational(-11), Rational(13, 5)}; }

/// The bodies exchanged.
template <class R>
Masses<R> exchanged(const Masses<R>& m) {
  return {m.second, m.first};
}
template <class R>
Velocities<R> exchanged(const Velocities<R>& v) {
  return {v.second, v.first};
}
template <class R>
Vector3<R> exchanged(const Vector3<R>& common) {
  return common;
}

/// A question with other masses or velocities.
template <class Asked>
Asked with_masses(Asked asked, const std::tuple_element_t<0, Asked>& masses) {
  std::get<0>(asked) = masses;
  return asked;
}
template <class Asked>
Asked with_velocities(Asked asked, const std::tuple_element_t<1, Asked>& velocities) {
  std::get<1>(asked) = velocities;
  return asked;
}

/// The bodies exchanged in the question are exchanged in the answer.
inline constexpr auto bodies_may_be_exchanged = [](const auto& ask, const auto& asked) {
  const auto other = with_velocities(with_masses(asked, exchanged(std::get<0>(asked))), exchanged(std::get<1>(asked)));
  return equal(ask(other), exchanged(ask(asked)));
};

/// Both masses times a power of two, where that is exact.
inline constexpr auto masses_have_any_unit = [](const auto& ask, const auto& asked) {
  const auto answer = ask(asked);
  for (const int k : {1, -1, 60, -60, 700, -700}) {
    const Massesd& m = std::get<0>(asked);
    const auto other = longer({m.first, m.second, 0}, k);
    if (other && !equal(ask(with_masses(asked, {other->x, other->y})), answer)) return false;
  }
  return true;
};

/// What another observer sees, who moves at a constant velocity, is the same law.
inline constexpr auto galilean_invariance = [](const auto& ask, const auto& asked) {
  const auto seen = ask(with_velocities(asked, with(std::get<1>(asked), a_shift())));
  if constexpr (requires { seen.first; }) return same(seen, with(ask(asked), a_shift()));
  else return same(seen, ask(asked) + a_shift());
};

/// These three.
template <class Row>
void impact_laws() {
  law<Row>("exchanged", bodies_may_be_exchanged);
  law<Row>("unit of mass", masses_have_any_unit);
  exact_law<Row>("galilean_invariance", galilean_invariance);
}

}  // namespace touchstone::proptests
