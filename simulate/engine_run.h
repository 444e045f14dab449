// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulate/engine_protocol.h"
#include "simulate/run.h"

namespace touchstone::simulate {

/// An engine crashed, hung or answered nonsense: one sentence.
struct EngineFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The lines to an engine and back.
class EngineLines {
 public:
  virtual ~EngineLines() = default;
  /// The next line that it answers. Throws EngineFailure.
  virtual std::string answer_to(const std::string& line) = 0;
};

/// A scene by a foreign engine. From the engine's own state the exact step of the scene is made beside its step: its
/// drift is what that exact step gains (`law` and `scheme`), and all that it gains beyond (`own`): its scheme, its
/// contacts, its thresholds and its rounding, which nobody outside can tell apart.
class EngineRun : public Run {
 public:
  /// `failure`: why it cannot begin; empty if it can. The scene has to outlive it.
  EngineRun(std::unique_ptr<EngineLines> lines, EngineHello hello, const std::string& failure, const Scene& scene);

  /// Asks the engine for its next step, and for nothing beside it. Throws EngineFailure and InvalidInput.
  Stepped<double> own_step();

  Log log_from(const State<double>&) const override { return {}; }
  const EngineRun* engine() const override { return this; }
  const EngineHello& hello() const { return hello_; }
  /// Whether it has said of every step so far which bodies it turned.
  bool tells_contacts() const { return tells_contacts_; }
  /// Whether it has been asked for a step, or can be: what it declares and where it stands are known.
  bool began() const { return steps_ > 0 || ended().empty(); }
  /// The scene needs what the engine does not have: no failure.
  bool unsupported() const { return unsupported_; }

 private:
  Stepped<double> step_from(const State<double>&) override { return own_step(); }

  const Scene& played_;
  std::unique_ptr<EngineLines> lines_;
  EngineHello hello_;
  std::uint64_t steps_ = 0;
  bool tells_contacts_ = true, unsupported_ = false;
};

/// Greets the engine. A run that cannot begin has ended; the reason says why. `taken`: names that other runs have.
std::unique_ptr<EngineRun> engine_run(std::unique_ptr<EngineLines> lines, const std::string& command,
                                      const Scene& scene, const std::vector<std::string>& taken);

}  // namespace touchstone::simulate
