// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>

#include "simulate/simulation.h"

namespace touchstone::simulate {

/// For people: for each run the energy, its drift in parts and the last hash; then where runs came apart, with a line
/// that asks the question of each. Of an engine: its thresholds, where it first differs from robust, and why it ended.
class Summary {
 public:
  explicit Summary(const Simulation& simulation);
  /// After each step; what was resumed is no step.
  void count();
  void print(std::ostream& out) const;

 private:
  const Simulation& simulation_;
  std::uint64_t first_;
  std::vector<std::size_t> contacts_;
};

}  // namespace touchstone::simulate
