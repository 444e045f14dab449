// SPDX-License-Identifier: Apache-2.0
#include "program/runs/audit_gate.h"

#include "audit/gate/baseline.h"
#include "audit/gate/junit.h"
#include "audit/gate/sarif.h"
#include "program/terminal/names.h"

namespace touchstone::program {
namespace {

Baseline read_from(const std::string& file) {
  const std::string text = text_of_file(file, "--baseline");
  try {
    return read_baseline(text);
  } catch (const InvalidInput& wrong) {
    throw UsageError("--baseline " + file + ": " + wrong.what());
  }
}

}  // namespace

Gate gate_of(const GateCommand& command) {
  Gate gate;
  try {
    if (command.fail_on) gate.causes = causes_named(*command.fail_on);
  } catch (const InvalidInput& wrong) {
    throw UsageError(std::string("--fail-on ") + wrong.what());
  }
  if (!command.baseline.empty()) gate.baseline = read_from(command.baseline);
  gate.max_rate = command.max_rate.value_or(0);
  // The baseline to read may be the one to write.
  if (command.write_baseline != command.baseline) require_writable("--write-baseline", command.write_baseline);
  require_writable("--junit", command.junit_file);
  require_writable("--sarif", command.sarif_file);
  return gate;
}

GateResult finish_gate(const GateCommand& command, Gate gate, const Tally& tally, std::ostream& out) {
  const Baseline found = baseline_of(tally, gate.causes);
  if (!gate.baseline && !command.write_baseline.empty()) gate.baseline = found;
  GateResult result = held_against(tally, gate);
  if (command.decides()) out << gate_in_words(tally, result) << std::flush;
  // From an interrupted audit the operations that it did not reach would be missing.
  if (!tally.interrupted) write_file("--write-baseline", command.write_baseline, baseline_json(found));
  write_file("--junit", command.junit_file, junit_xml(tally, result));
  write_file("--sarif", command.sarif_file, sarif_json(tally, gate, result, command.source));
  return result;
}

}  // namespace touchstone::program
