// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace touchstone::catalogue {

/// The simplest draw stream that is still `interesting`, found by dropping, zeroing and lessening bytes. Because inputs
/// are drawn from integer parameters, a shrunk input stays in its family: a degenerate case stays degenerate.
/// Deterministic; calls `interesting` at most `budget` times.
std::vector<std::uint8_t> shrunk(std::vector<std::uint8_t> draws,
                                 const std::function<bool(const std::vector<std::uint8_t>&)>& interesting,
                                 int budget = 2000);

}  // namespace touchstone::catalogue
