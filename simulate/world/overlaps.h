// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "simulate/world/scene.h"

namespace touchstone::simulate {

struct BrokenRule {
  std::string field, rule;
};

/// The first two bodies, or body and wall, that overlap at the start, decided exactly. Touching is not overlapping, and
/// two fixed bodies may overlap.
std::optional<BrokenRule> overlap_at_start(const Scene& scene);

}  // namespace touchstone::simulate
