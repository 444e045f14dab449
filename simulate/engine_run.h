// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulate/engine_protocol.h"
#include "simulate/run.h"

namespace touchstone::simulate {

/// An engine crashed, hung or gave a malformed answer: one sentence.
struct EngineFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The exchange of lines with an engine.
class EngineLines {
 public:
  virtual ~EngineLines() = default;
  /// Its next line in answer. Throws EngineFailure.
  virtual std::string answer_to(const std::string& line) = 0;
};

/// A scene run by a foreign engine. From the engine's own state the exact step of the scene is computed next to its
/// step: its drift is the gain of that exact step (`law` and `scheme`), and the rest (`own`): its scheme, its contacts,
/// its thresholds and its rounding, which are indistinguishable from outside.
class EngineRun : public Run {
 public:
  /// `failure`: the reason why it cannot begin; empty if it can. The scene has to outlive it.
  EngineRun(std::unique_ptr<EngineLines> lines, EngineHello hello, const std::string& failure, const Scene& scene);

  /// Asks the engine only for its next step. Throws EngineFailure and InvalidInput.
  Stepped<double> own_step();

  Log log_from(const State<double>&) const override { return {}; }
  const EngineRun* engine() const override { return this; }
  const EngineHello& hello() const { return hello_; }
  /// True if it has reported for every step so far which bodies changed velocity.
  bool tells_contacts() const { return tells_contacts_; }
  /// True if it has been asked for a step, or can be: then its declaration and state are known.
  bool began() const { return steps_ > 0 || ended().empty(); }
  /// True if the scene needs a feature that the engine lacks: not a failure.
  bool unsupported() const { return unsupported_; }

 private:
  Stepped<double> step_from(const State<double>&) override { return own_step(); }

  const Scene& played_;
  std::unique_ptr<EngineLines> lines_;
  EngineHello hello_;
  std::uint64_t steps_ = 0;
  bool tells_contacts_ = true, unsupported_ = false;
};

/// Greets the engine. A run that cannot begin has ended, with the reason. `taken`: names of other runs.
std::unique_ptr<EngineRun> engine_run(std::unique_ptr<EngineLines> lines, const std::string& command,
                                      const Scene& scene, const std::vector<std::string>& taken);

}  // namespace touchstone::simulate
