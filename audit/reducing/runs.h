// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "audit/reducing/search.h"

namespace touchstone::audit::reducing {

/// A sequence from which a pass drops runs.
struct Sequence {
  /// Its length in the best question of the search; called before any `without` of that question.
  std::function<std::size_t()> length;
  /// The best question without first <= i < last of it, or nullopt.
  std::function<std::optional<Question>(std::size_t first, std::size_t last)> without;
  std::size_t least = 1;  ///< length of the shortest runs
  bool give_up = false;   ///< once halves and quarters are all outside the contract
};

/// Delta debugging: drops all of a sequence, halves, quarters, down to the shortest runs. Returns whether it dropped
/// any.
bool drop_runs(Search& search, const Sequence& sequence);

}  // namespace touchstone::audit::reducing
