// SPDX-License-Identifier: Apache-2.0
#include "program/run_options.h"

namespace touchstone::program {

void add_gate(CLI::App& command, GateCommand& gate) {
  const CLI::Validator rate(
      [](std::string& text) {
        double value = 0;
        const bool right = CLI::detail::lexical_cast(text, value) && value >= 0 && value <= 1;
        return right ? std::string() : text + ": a number from 0 to 1";
      },
      "RATE");
  command.add_option(
      "--fail-on", gate.fail_on,
      "Causes, separated by commas, that fail the audit: rounding (cancellation, out_of_range), algorithm, inexact, "
      "invalid, not_asked, inconsistent_convention, surplus (these by default), convention, tolerance, unsupported; "
      "none");
  command.add_option("--baseline", gate.baseline, "Findings in this file are known and do not fail the audit");
  command.add_option("--write-baseline", gate.write_baseline, "Write the findings into this file as known");
  command
      .add_option("--max-rate", gate.max_rate,
                  "Largest accepted share of an operation's cases with findings that are not known (default 0)")
      ->check(rate);
  command
      .add_option("--max-surplus", gate.max_surplus,
                  "Largest accepted share of separated pairs in lists of pairs (default 0.75)")
      ->check(rate);
  command.add_option("--junit", gate.junit_file, "Write the result as JUnit's XML into this file");
  command.add_option("--sarif", gate.sarif_file, "Write the result as SARIF 2.1.0 into this file");
  command.add_option("--source", gate.source,
                     "File of the engine's code, at which a SARIF viewer shows the results; of recorded calls it is "
                     "the line of the call");
}

void add_shard(CLI::App& command, std::string& shard, std::string& json_file) {
  command
      .add_option("--shard", shard,
                  "I/N: run the I-th of N parts; its state is kept in FILE.part next to --json FILE, and the same "
                  "command resumes from it after an interruption")
      ->default_str("of the launcher");
  command.add_option("--json", json_file, "Write the result to this file; - is standard output")->default_str("");
}

}  // namespace touchstone::program
