// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "geometry/validation_of_bodies.h"
#include "robust/kernel/shapes/valid_space.h"

/// Checks whether bodies are valid; the rules are those of geometry/validation_of_bodies.h (see valid.h).
namespace touchstone::robust::kernel {

inline bool valid(const Massesd& m) {
  return all_finite(m.first, m.second) && validation::positive(m.first) && validation::positive(m.second);
}
inline bool valid(const Velocitiesd& v) { return valid(v.first) && valid(v.second); }
inline bool valid_restitution(double e) { return all_finite(e) && !validation::negative(e) && in_order(e, 1); }
inline bool valid(const Bodyd& body) {
  return all_finite(body.mass) && validation::positive(body.mass) && valid(body.velocity);
}
inline bool valid(const MovingBodyd& body) {
  return valid(body.position) && valid(body.velocity) && valid(body.angular_velocity);
}
inline void validate_bodies(const std::vector<Bodyd>& bodies) {
  if (std::all_of(bodies.begin(), bodies.end(), [](const Bodyd& body) { return valid(body); })) return;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    validation::validate_numbers("bodies[" + std::to_string(i) + "]", bodies[i]);
  for (std::size_t i = 0; i < bodies.size(); ++i) validation::validate("bodies[" + std::to_string(i) + "]", bodies[i]);
}

}  // namespace touchstone::robust::kernel
