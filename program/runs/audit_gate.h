// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <ostream>
#include <string>

#include "audit/gate/gate.h"
#include "program/terminal/uses.h"

namespace touchstone::program {

/// What of `audit` is for CI.
struct GateCommand {
  std::optional<std::string> fail_on;  ///< causes with commas
  std::string baseline, write_baseline;
  std::optional<double> max_rate;
  double max_surplus = audit::usual_surplus;
  std::string junit_file, sarif_file;
  std::string source = "engine";  ///< what the results in a SARIF file refer to

  /// Whether the gate decides on the exit code.
  bool decides() const { return fail_on || max_rate || !baseline.empty() || !write_baseline.empty(); }
};

/// Reads the baseline and opens what will be written, before the first question. Throws UsageError naming the option.
Gate gate_of(const GateCommand& command);

/// Holds an audit against the gate, says the result where it decides, and writes the files. Without a baseline what is
/// written as one is known at once.
GateResult finish_gate(const GateCommand& command, Gate gate, const Tally& tally, std::ostream& out);

}  // namespace touchstone::program
