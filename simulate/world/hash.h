// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "simulate/world/scene.h"

namespace touchstone::simulate {

/// The hash of the bodies of a scene in that state. It does not depend on their order, nor on names, nor on the sign of
/// 0; different states collide with probability 2^-64.
std::uint64_t hash_of(const Scene& scene, const State<double>& state);
/// The hash of a run up to a step: combines the chain before it and that step's hash.
std::uint64_t chained(std::uint64_t chain, std::uint64_t hash);
/// Sixteen hexadecimal digits.
std::string in_digits(std::uint64_t hash);

}  // namespace touchstone::simulate
