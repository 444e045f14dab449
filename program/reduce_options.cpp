// SPDX-License-Identifier: Apache-2.0
#include "program/reduce_options.h"

#include <iostream>
#include <memory>

#include "program/commands/recorded/reduce.h"
#include "program/mesh_options.h"
#include "program/option_rules.h"

namespace touchstone::program {

void add_reduce(CLI::App& program, std::function<int()>& action) {
  auto* command =
      program.add_subcommand("reduce", "The smallest input on which an implementation fails in the same way");
  auto options = std::make_shared<ReduceCommand>();
  command->add_option("operation", options->operation, "Name of the operation")->required();
  command->add_option("file", options->file, "One question in JSON; - is standard input")
      ->default_str("standard input, or none where --mesh gives every field");
  add_engine(*command, options->engine, options->timeout, "Engine that has to keep failing with the same cause");
  auto* engine = command->get_option("--engine");
  auto* with =
      command
          ->add_option("--with", options->with, "reference: the textbook formula in double; reference,float: in float")
          ->check(CLI::IsMember({"reference", "reference,float"}))
          ->excludes(engine)
          ->default_str("reference");
  command
      ->add_option("--until", options->until,
                   "Command that reads a question, one line of JSON, and has to keep exiting with code 0")
      ->check(a_command)
      ->excludes(engine)
      ->excludes(with)
      ->default_str("");
  command->add_flag("--any-answer", options->any_answer,
                    "Accept the same cause, whatever the truth and the answer are");
  command->add_flag("--allow-degenerate", options->allow_degenerate,
                    "Points may become equal or collinear, radii 0 and so on, even if those of the question are not");
  command->add_flag("--allow-invalid", options->allow_invalid,
                    "Also try questions outside the contract: for a crash, or with --until");
  command->add_option("--seconds", options->seconds, "Time limit; prints the smallest question found by then")
      ->check(positive)
      ->default_str("none");
  command
      ->add_option("--jobs", options->jobs,
                   "Threads, each with its own engine process; the result does not depend on it")
      ->check(any_jobs)
      ->default_str("one a processor");
  command
      ->add_option("--out", options->directory,
                   "Directory for the question, its meshes, a picture, regression tests and a report to paste")
      ->default_str("");
  add_file_meshes(*command, options->meshes, options->preparation);
  auto* wkt = command->add_flag("--wkt", options->wkt, "The question is WKT, as in ask");
  command->add_flag("--geojson", options->geojson, "The question is GeoJSON, as in ask")->excludes(wkt);
  command->callback([=, &action] {
    options->program = command->get_parent()->get_name();
    action = [=] { return reduce_command(*options, std::cout, std::cerr); };
  });
}

}  // namespace touchstone::program
