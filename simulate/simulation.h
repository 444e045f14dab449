// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulate/engine_run.h"
#include "simulate/parting.h"

namespace touchstone::simulate {

/// True if two runs answered the same contacts in the same order.
bool same_contacts(const Snapshot& a, const Snapshot& b);

/// True if they answered the same contacts, in any order and multiplicity.
bool same_set_of_contacts(const Snapshot& a, const Snapshot& b);

/// The first difference of an engine from robust; 0: none so far.
struct Departure {
  std::uint64_t numbers = 0, contacts = 0;  ///< steps, from 1
  std::vector<Touch> of_engine, of_robust;  ///< contacts of that step
};

/// Runs of one scene, side by side.
class Simulation {
 public:
  /// The names of the runs, from `all_runs`, without duplicates. The scene has to outlive it.
  Simulation(const Scene& scene, const std::vector<std::string>& runs);

  const Scene& scene() const { return scene_; }
  std::uint64_t step() const { return step_; }
  std::size_t size() const { return runs_.size(); }
  const Run& run(std::size_t i) const { return *runs_[i]; }
  /// For the runs that have diverged so far, at most one for each pair of them.
  const std::vector<Parting>& partings() const { return partings_; }
  /// True if there are two runs, and none has answered other contacts than another so far. Engines do not count.
  bool none_parted() const;
  /// For an engine's run, relative to robust, if robust runs too.
  const Departure& departure(std::size_t i) const { return departures_[i]; }
  /// Adds an engine before the first step.
  void add(std::unique_ptr<EngineRun> run);
  std::vector<std::string> names() const;

  /// Makes a step in every run. Throws StepError, which names step and run; the simulation cannot continue then. An
  /// engine that fails ends alone.
  void advance();
  /// Continues after that step, with the snapshot and the drift of each run. Runs that have diverged stay so.
  void restore(std::uint64_t step, const std::vector<Snapshot>& then, const std::vector<Drift>& drifts,
               const std::vector<std::pair<std::size_t, std::size_t>>& parted);

 private:
  void look_for_partings(const std::vector<State<double>>& before);
  void look_for_departures();

  const Scene& scene_;
  std::uint64_t step_ = 0;
  std::vector<std::unique_ptr<Run>> runs_;
  std::vector<std::vector<bool>> parted_;  ///< by the indices of two runs
  std::vector<Parting> partings_;
  std::vector<Departure> departures_;  ///< by the index of the run
};

}  // namespace touchstone::simulate
