// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "simulate/world/energy.h"
#include "simulate/world/step.h"

namespace touchstone::simulate {

/// A run after a step. Numbers of a run in float are the doubles equal to them.
struct Snapshot {
  State<double> state;
  std::vector<Impact> impacts;  ///< of that step; none at the start
  mpq_class energy;
  std::array<mpq_class, 3> momentum;
  Drift drift;  ///< of that step
  std::uint64_t hash = 0, chain = 0;
};

class EngineRun;

/// A scene in one arithmetic, or by a foreign engine.
class Run {
 public:
  virtual ~Run() = default;
  const std::string& name() const { return name_; }
  const Snapshot& now() const { return now_; }
  /// Since the start.
  const Drift& drift() const { return drift_; }

  /// Makes a step. Throws StepError.
  void advance();
  /// The reason why it makes no more steps; empty while it does. Only runs of engines end before the others.
  const std::string& ended() const { return ended_; }
  void end(std::string why) { ended_ = std::move(why); }
  /// The questions of the step from that state, in their order; none for an engine, which is not asked for them.
  virtual Log log_from(const State<double>& state) const = 0;
  virtual const EngineRun* engine() const { return nullptr; }
  /// Continues from a snapshot of this scene, of which only the state is used.
  void restore(const Snapshot& then, const Drift& drift);

 protected:
  Run(std::string name, const Scene& scene) : name_(std::move(name)), scene_(scene) {}
  /// Sets the start of the scene, with each number rounded to the arithmetic. If another run of the scene starts from
  /// the same bits, shares its data.
  void begin(const State<double>& state, const Run* other = nullptr);

 private:
  virtual Stepped<double> step_from(const State<double>& state) = 0;
  void describe(const State<double>& state);
  Stepped<Exact> ideal_step(const State<Exact>& start);

  std::string name_;
  const Scene& scene_;
  std::optional<World<Formulas<Exact>>> exact_;  ///< made with the first step
  Nearby nearby_exact_;
  Snapshot now_;
  Drift drift_;
  std::string ended_;
};

inline constexpr const char* all_runs[]{"float", "double", "robust"};

/// The run of one of these names; the scene has to outlive it. `other`: a run of the same scene that has made no step.
std::unique_ptr<Run> run_of(const std::string& name, const Scene& scene, const Run* other = nullptr);

}  // namespace touchstone::simulate
