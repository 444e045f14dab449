// SPDX-License-Identifier: Apache-2.0
#include "program/log_options.h"

#include <iostream>

#include "program/commands/recorded/against.h"
#include "program/commands/recorded/judge.h"
#include "program/commands/recorded/log.h"
#include "program/option_rules.h"
#include "program/run_options.h"

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
  convert->add_option("out", options->out, "Output file; - is standard output")->required();
  convert->add_option("--to", options->to, "Output form: json or binary")
      ->check(CLI::IsMember({"json", "binary"}))
      ->default_str("the other");
  convert->callback([=, &action] { action = [=] { return log_convert_command(*options, std::cout, std::cerr); }; });
}

void add_judge(CLI::App& program, Action& action) {
  auto* command =
      program.add_subcommand("judge", "How often recorded calls were answered wrongly, and why (docs/own_inputs.md)");
  auto options = std::make_shared<JudgeCommand>();
  command->add_option("files", options->files, "Logs, compressed by gzip or zstd or not; - is standard input")
      ->required();
  command->add_option("--ops", options->operations, "Only calls of these operations, separated by commas");
  command
      ->add_option("--boundary", options->boundary,
                   "How the recorded functions treat shapes that only touch: closed, open or unspecified")
      ->check(CLI::IsMember({"closed", "open", "unspecified"}))
      ->default_str("as the log says");
  command->add_option("--tolerance", options->tolerance, "Their tolerance, in the unit of the coordinates")
      ->check(positive)
      ->default_str("as the log says");
  auto* pairs =
      command
          ->add_option("--pairs", options->pairs,
                       "The files are meshes, WKT or GeoJSON: ask --engine this operation for all pairs of shapes")
          ->default_str("");
  auto* columns =
      command
          ->add_option("--columns", options->columns,
                       "The files have one question per line and one number per column: ask --engine this operation")
          ->excludes(pairs)
          ->default_str("");
  auto* engine = command->add_option("--engine", options->engine, "Answers the questions of --pairs and --columns")
                     ->check(a_command)
                     ->default_str("");
  command
      ->add_option(
          "--against", options->against,
          "An engine that is asked the same: lists the calls on which it differs from the log, and which is right")
      ->check(a_command)
      ->excludes(pairs, columns, engine)
      ->default_str("");
  command->add_option("--timeout", options->timeout, "Time limit in seconds for one answer of the engine")
      ->check(positive);
  command->add_option("--jobs", options->jobs, "Threads")->check(any_jobs)->default_str("one a processor");
  add_shard(*command, options->shard, options->json_file);
  command->add_option("--report", options->report_directory, "Write HTML pages into this directory");
  add_gate(*command, options->gate);
  command->add_flag("--summary", options->summary, "A row for each operation, without call sites and examples");
  command->callback([=, &action] {
    options->program = command->get_parent()->get_name();
    action = [=] {
      return options->against.empty() ? judge_command(*options, std::cout, std::cerr)
                                      : judge_against_command(*options, std::cout, std::cerr);
    };
  });
}

}  // namespace touchstone::program
