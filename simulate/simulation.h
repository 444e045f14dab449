// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulate/engine_run.h"
#include "simulate/parting.h"

namespace touchstone::simulate {

/// Whether two runs answered the same contacts in the same order.
bool same_contacts(const Snapshot& a, const Snapshot& b);

/// The same, whatever their order and however often.
bool same_set_of_contacts(const Snapshot& a, const Snapshot& b);

/// Where an engine first differs from robust; 0: nowhere so far.
struct Departure {
  std::uint64_t numbers = 0, contacts = 0;  ///< steps, from 1
  std::vector<Touch> of_engine, of_robust;  ///< contacts of that step
};

/// Runs of one scene, side by side.
class Simulation {
 public:
  /// The names of the runs, of `all_runs`, each once. The scene has to outlive it.
  Simulation(const Scene& scene, const std::vector<std::string>& runs);

  const Scene& scene() const { return scene_; }
  std::uint64_t step() const { return step_; }
  std::size_t size() const { return runs_.size(); }
  const Run& run(std::size_t i) const { return *runs_[i]; }
  /// Of the runs that have parted so far, at most one for each two of them.
  const std::vector<Parting>& partings() const { return partings_; }
  /// Whether there are two runs, and none has answered other contacts than another so far. Engines do not count.
  bool none_parted() const;
  /// Of a run that is an engine's, from robust, where robust runs too.
  const Departure& departure(std::size_t i) const { return departures_[i]; }
  /// Adds an engine before the first step.
  void add(std::unique_ptr<EngineRun> run);
  std::vector<std::string> names() const;

  /// Makes a step in every run. Throws StepError, which names step and run; there is no going on then. An engine that
  /// fails ends alone.
  void advance();
  /// Goes on after that step, with the snapshot and the drift of each run. Runs that have parted stay so.
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
