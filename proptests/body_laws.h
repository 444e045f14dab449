// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "catalogue/families/bodies/body_draws.h"
#include "proptests/response_laws.h"

/// Laws of lists of bodies.
namespace touchstone::proptests {

using ExactBodies = std::vector<Body<Rational>>;
using catalogue::Bodies;

inline Rational mass_of(const ExactBodies& bodies) {
  Rational sum;
  for (const auto& body : bodies) sum += body.mass;
  return sum;
}

/// As another observer sees them.
inline ExactBodies with(ExactBodies bodies, const Motion3& shift) {
  for (auto& body : bodies) body.velocity = body.velocity + shift;
  return bodies;
}

/// The sum is the same in whatever order it is taken.
inline constexpr auto in_any_order = [](const auto& ask, const auto& asked) {
  auto bodies = std::get<0>(asked);
  const auto answer = ask(asked);
  std::reverse(bodies.begin(), bodies.end());
  if (!equal(ask(std::tuple(bodies)), answer)) return false;
  if (bodies.size() > 1) std::rotate(bodies.begin(), bodies.begin() + 1, bodies.end());
  return equal(ask(std::tuple(bodies)), answer);
};

/// All masses times 2^k, where that is exact.
inline std::optional<Bodies> heavier(Bodies bodies, int k) {
  for (auto& [mass, velocity] : bodies) {
    const double times = std::ldexp(mass, k);
    if (!finite(times) || std::ldexp(times, -k) != mass) return std::nullopt;
    mass = times;
  }
  return bodies;
}
inline constexpr auto masses_scale = [](const auto& ask, const auto& asked) {
  const auto answer = ask(asked);
  for (const int k : {1, -30, 400, -400}) {
    const auto other = heavier(std::get<0>(asked), k);
    if (!other) continue;
    const auto found = ask(std::tuple(*other));
    if constexpr (requires { found.x; }) {
      if (!scaled_vector(answer, found, k)) return false;
    } else {
      if (!scaled_number(answer, found, k)) return false;
    }
  }
  return true;
};

/// More bodies than a sum of enclosed numbers takes, which nearly cancel.
inline Bodies thousands_of_bodies() {
  Bodies bodies;
  for (int i = 0; i < 4100; ++i) {
    const double x = 1 + i / 4096.0, sign = i % 2 == 0 ? 1 : -1;
    bodies.push_back({1 + i * 0x1p-30, {sign * x, 0.1, sign / x}});
  }
  return bodies;
}

}  // namespace touchstone::proptests
