// SPDX-License-Identifier: Apache-2.0
#include "program/log_options.h"

#include <iostream>

#include "program/commands/log.h"

namespace touchstone::program {

void add_log(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("log", "Logs of recorded calls (docs/own_inputs.md)");
  command->require_subcommand(1);
  auto files = std::make_shared<std::vector<std::string>>();
  auto* show = command->add_subcommand("show", "What logs hold: calls by operation, place and answer");
  show->add_option("files", *files, "Logs, compressed by gzip or zstd or not; - is standard input")->required();
  show->callback([=, &action] { action = [=] { return log_show_command(*files, std::cout); }; });
  auto options = std::make_shared<LogConvertCommand>();
  auto* convert = command->add_subcommand("convert", "Writes a log in the other form: as JSON lines, or as binary");
  convert->add_option("in", options->in, "The log; - is standard input")->required();
  convert->add_option("out", options->out, "Where to; - is standard output")->required();
  convert->add_option("--to", options->to, "This form, whichever the log has: json or binary")
      ->check(CLI::IsMember({"json", "binary"}))
      ->default_str("the other");
  convert->callback([=, &action] { action = [=] { return log_convert_command(*options, std::cout, std::cerr); }; });
}

}  // namespace touchstone::program
