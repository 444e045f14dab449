// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulate/trajectory.h"

namespace touchstone::simulate {

/// The data of every step that a page shows, as nearest doubles.
class Recording {
 public:
  struct OfRun {
    std::string name;
    std::vector<State<double>> states;
    std::vector<std::vector<Impact>> impacts;
    std::vector<double> energy, law, scheme, decision, rounding;  ///< drift since the start
    std::vector<std::array<double, 3>> momentum;
    bool engine = false;  ///< for an engine, rounding holds everything that is its own
    std::string ended;    ///< the reason why it has fewer steps than the others
  };

  explicit Recording(const Simulation& simulation);
  /// Adds the current state of the simulation.
  void add(const Simulation& simulation);
  /// Adds a step that was read back.
  void add(const Frame& frame);

  const Scene& scene() const { return scene_; }
  const std::vector<OfRun>& runs() const { return runs_; }
  std::size_t frames() const { return runs_[0].states.size(); }
  /// Steps and partings, in the form of a trajectory's lines.
  const std::vector<std::pair<std::uint64_t, Json>>& partings() const { return partings_; }

 private:
  static void add(OfRun& run, const Snapshot& now, const Drift& drift);

  const Scene& scene_;
  std::vector<OfRun> runs_;
  std::vector<std::pair<std::uint64_t, Json>> partings_;
};

}  // namespace touchstone::simulate
