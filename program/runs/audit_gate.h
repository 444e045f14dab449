// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <ostream>
#include <string>

#include "audit/gate/gate.h"
#include "program/terminal/uses.h"

namespace touchstone::program {

/// The options of `audit` for CI.
struct GateCommand {
  std::optional<std::string> fail_on;  ///< causes separated by commas
  std::string baseline, write_baseline;
  std::optional<double> max_rate;
  double max_surplus = audit::usual_surplus;
  std::string junit_file, sarif_file;
  std::string source = "engine";  ///< the file to which the results in a SARIF file refer

  /// True if the gate determines the exit code.
  bool decides() const { return fail_on || max_rate || !baseline.empty() || !write_baseline.empty(); }
};

/// Reads the baseline and opens the output files, before the first question. Throws UsageError naming the option.
Gate gate_of(const GateCommand& command);

/// Applies the gate to an audit, prints the result if the gate decides, and writes the files. Without a baseline to
/// read, the findings written as one are known at once.
GateResult finish_gate(const GateCommand& command, Gate gate, const Tally& tally, std::ostream& out);

}  // namespace touchstone::program
