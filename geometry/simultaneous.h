// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "geometry/bodies.h"

namespace touchstone {

/// Decides whether bodies can move so that no contact's demand is broken.
enum class Resolution { possible, impossible };
constexpr auto words_of(Resolution) { return as_words("possible", "impossible"); }

/// relation `possible`: the velocities after, one for each body. `impossible`: the contacts contradict each other, and
/// there are none.
template <class Real>
struct SimultaneousVelocities {
  Resolution relation;
  std::optional<std::vector<Vector3<Real>>> velocities;
  static constexpr auto members = as_record("relation", "velocities");
};

using SimultaneousVelocitiesd = SimultaneousVelocities<double>;

}  // namespace touchstone
