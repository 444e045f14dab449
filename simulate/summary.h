// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <ostream>
#include <vector>

#include "simulate/simulation.h"

namespace touchstone::simulate {

/// A summary for people: for each run the energy, its drift in parts and the last hash; how high bodies bounce; then
/// where runs diverged, with a command that asks the question of each. For an engine: its thresholds, its first
/// difference from robust, and the reason why it ended.
class Summary {
 public:
  explicit Summary(const Simulation& simulation);
  /// Call after each step; resumed steps do not count.
  void count();
  void print(std::ostream& out) const;

 private:
  /// The height to which a body rises after a contact with a wall, and its ratio to the previous one, if that was with
  /// the same wall and nothing lay between.
  struct Bounce {
    double rise;
    std::optional<double> ratio;
  };
  struct OfRun {
    std::size_t contacts = 0;
    std::map<std::size_t, std::pair<std::size_t, double>> last;                  ///< for a body: wall and rise
    std::map<std::pair<std::size_t, std::size_t>, std::vector<Bounce>> bounces;  ///< by body and wall
  };
  void count(OfRun& run, const Impact& impact);
  void print_bounces(std::size_t run, std::ostream& out) const;

  const Simulation& simulation_;
  std::uint64_t first_;
  std::vector<OfRun> runs_;
};

}  // namespace touchstone::simulate
