// SPDX-License-Identifier: Apache-2.0
#include "program/option_rules.h"

#include <fmt/format.h>

#include <charconv>

#include "program/commands/commands.h"

namespace touchstone::program {

const CLI::Validator positive(
    [](std::string& text) {
      double value = 0;
      return CLI::detail::lexical_cast(text, value) && value > 0 ? std::string()
                                                                 : "expected a number greater than 0, got " + text;
    },
    "POSITIVE");

CLI::Validator integer_in_range(std::uint64_t least, std::uint64_t most) {
  const std::string rule = fmt::format("an integer from {} to {}", least, most);
  return CLI::Validator(
      [=](std::string& text) {
        std::uint64_t value = 0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        const bool right = error == std::errc() && stop == end && value >= least && value <= most;
        return right ? std::string() : "expected " + rule + ", got " + text;
      },
      "WHOLE");
}
const CLI::Validator any_seed = integer_in_range(0, UINT64_MAX), any_cases = integer_in_range(1, most_cases),
                     any_jobs = integer_in_range(1, 1024);

const CLI::Validator a_command(
    [](std::string& text) {
      const bool empty = text.find_first_not_of(" \t\r\n") == std::string::npos;
      return empty ? std::string("expected the command of an engine, got an empty one (is a variable not set?)") : "";
    },
    "");

void add_engine(CLI::App& command, std::string& engine, double& timeout, const std::string& what) {
  command.add_option("--engine", engine, "Command of an engine (docs/engines.md). " + what)->check(a_command);
  command.add_option("--timeout", timeout, "Time limit in seconds for one answer of the engine")->check(positive);
}

}  // namespace touchstone::program
