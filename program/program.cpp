// SPDX-License-Identifier: Apache-2.0
#include "program/program.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "audit/engines/engine.h"
#include "audit/limb_memory.h"
#include "audit/platform.h"
#include "audit/text/regression_test.h"
#include "catalogue/codec/excerpt.h"
#include "program/command_tree.h"
#include "program/commands/commands.h"
#include "program/commands/map.h"
#include "program/commands/recorded/against.h"
#include "program/documentation.h"
#include "program/log_options.h"
#include "program/mesh_options.h"
#include "program/option_rules.h"
#include "program/reduce_options.h"
#include "program/run_options.h"

namespace touchstone::program {
namespace {

void add_ops(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("ops", "The catalogue of operations");
  auto json = std::make_shared<bool>(false), markdown = std::make_shared<bool>(false);
  auto words = std::make_shared<std::vector<std::string>>();
  auto* search =
      command->add_option("word", *words, "Only the operations that match these words best, best match first");
  auto* as_json = command->add_flag("--json", *json, "Machine-readable")->excludes(search);
  command->add_flag("--markdown", *markdown, "The page docs/operations.md: C++ signatures, JSON fields, words")
      ->excludes(as_json)
      ->excludes(search);
  command->callback([=, &action] {
    action = [=] {
      if (!words->empty()) return ops_search_command(*words, std::cout);
      return *markdown ? operations_page_command(std::cout) : ops_command(*json, std::cout);
    };
  });
}

void add_ask(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("ask", "Truth, certificate, robust and reference for one JSON input a line");
  auto options = std::make_shared<AskCommand>();
  command->add_option("operation", options->operation, "Name of the operation")->required();
  command->add_option("file", options->file, "JSON lines; - is standard input");
  auto* as_typed = command->add_flag("--as-typed", options->as_typed,
                                     "Also print the truth for the decimals as typed, before rounding to double");
  auto* truth = command->add_flag("--truth", options->truth,
                                  "Print only the truth and its margin: no certificate, no robust, no reference");
  command->add_option("--as", options->as, "Print regression tests of your own code instead")
      ->check(CLI::IsMember(std::vector<std::string>(test_frameworks.begin(), test_frameworks.end())))
      ->excludes(as_typed)
      ->excludes(truth)
      ->default_str("");
  add_engine(*command, options->engine, options->timeout, "Asked as well, and judged");
  auto* mesh = add_file_meshes(*command, options->meshes, options->preparation);
  command
      ->add_flag("--verbose", options->verbose,
                 "Report on standard error what was read from a mesh file, and how it was converted")
      ->needs(mesh);
  auto* wkt = command->add_flag("--wkt", options->wkt,
                                "Each line is WKT: one geometry per field, in field order, separated by semicolons");
  command
      ->add_flag("--geojson", options->geojson,
                 "The input is GeoJSON texts of one or more lines: one geometry per field, in field order")
      ->excludes(wkt);
  command->callback([=, &action] { action = [=] { return ask_command(*options, std::cout, std::cerr); }; });
}

void add_audit(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("audit", "How often an implementation is wrong, and why");
  auto options = std::make_shared<AuditCommand>();
  command
      ->add_option("--engine", options->engine,
                   "Command that answers questions over pipes; without it, the textbook formulas in double")
      ->check(a_command);
  command
      ->add_option(
          "--against", options->against,
          "A second engine: lists the questions on which the two differ, and which one is right, smallest first")
      ->check(a_command)
      ->default_str("");
  command->add_option("--ops", options->operations, "Operations, separated by commas, or all");
  command->add_option("--cases", options->cases, "Questions per operation")->check(any_cases);
  command->add_flag(
      "--by-cost", options->by_cost,
      "Fewer questions for operations that cost more than ten times the cheapest, in proportion to the cost, "
      "but at least 100: a quick look at all operations");
  command
      ->add_option("--seconds", options->seconds, "Time limit per operation, including the reduction of its findings")
      ->check(positive)
      ->default_str("none");
  command->add_option("--seed", options->seed, "Same seed, same questions")->check(any_seed);
  command->add_option("--families", options->families, "Families of inputs, separated by commas (see ops --json)");
  command->add_option("--jobs", options->jobs, "Threads, each with its own engine process")
      ->check(any_jobs)
      ->default_str("one a processor");
  command->add_option("--timeout", options->timeout, "Time limit in seconds for one answer of an engine")
      ->check(positive);
  add_shard(*command, options->shard, options->json_file);
  command->add_option("--report", options->report_directory, "Write HTML pages into this directory");
  command
      ->add_option("--report-seconds", options->report_seconds,
                   "Time for refining the failure maps of the report; without it a map has at most "
                   "--cases squares, and the same arguments give the same bytes")
      ->check(positive)
      ->default_str("none");
  command->add_option("--before", options->before,
                      "File of an earlier audit's --json: the report shows both, as before and after a fix");
  command->add_option("--range", options->range, "ordinary: only inputs of ordinary magnitude; all: any input")
      ->check(CLI::IsMember({"ordinary", "all"}));
  command->add_option(
      "--ordinary", options->ordinary,
      "LEAST,MOST: a number is of ordinary magnitude if it is 0 or its absolute value lies between these");
  add_gate(*command, options->gate);
  auto* summary =
      command->add_flag("--summary", options->summary, "A row for each operation, without families and examples");
  command->add_option("--width", options->width,
                      "Columns after which a question or an answer is truncated on the screen; 0 = never");
  command
      ->add_flag("--verbose", options->verbose,
                 "Print every family and finding on a terminal, too, instead of one screen")
      ->excludes(summary);
  command->callback([=, &action] {
    options->program = command->get_parent()->get_name();
    action = [=] {
      return options->against.empty() ? audit_command(*options, std::cout, std::cerr)
                                      : audit_against_command(*options, std::cout, std::cerr);
    };
  });
}

void add_check_engine(CLI::App& program, Action& action) {
  auto* command =
      program.add_subcommand("check-engine", "Five easy questions an operation: is an engine connected correctly?");
  auto options = std::make_shared<CheckEngineCommand>();
  command->add_option("engine", options->engine, "Command of the engine (docs/engines.md)")
      ->required()
      ->check(a_command);
  command->add_option("--timeout", options->timeout, "Time limit in seconds for one answer")->check(positive);
  command->callback([=, &action] { action = [=] { return check_engine_command(*options, std::cout, std::cerr); }; });
}

void add_draw(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("draw", "Questions with their truth as JSON lines, for tests in any language");
  auto options = std::make_shared<DrawCommand>();
  command->add_option("operation", options->operation, "Name of the operation")->required();
  command->add_option("--families", options->families, "Families of inputs, separated by commas (see ops --json)");
  command->add_option("--cases", options->cases, "Number of questions, distributed evenly over the families")
      ->check(any_cases);
  command->add_option("--seed", options->seed, "Same seed, same questions")->check(any_seed);
  command->add_option("--range", options->range, "ordinary: only inputs of ordinary magnitude; all: any input")
      ->check(CLI::IsMember({"ordinary", "all"}));
  command->add_flag("--binary32", options->binary32, "Every number is exact in float");
  command->callback([=, &action] { action = [=] { return draw_command(*options, std::cout); }; });
}

void add_exhaust(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("exhaust", "Every configuration on a small grid");
  auto options = std::make_shared<ExhaustCommand>();
  command->add_option("operation", options->operation, "Name of the operation")->required();
  command->add_option("--grid", options->grid, "Every coordinate takes the values 0 .. K-1")->check(CLI::Range(1, 64));
  command
      ->add_option("--list-length", options->list_length,
                   "Number of elements of each list, such as vertices of a polygon")
      ->check(CLI::Range(1, 64))
      ->default_str("as the tests ask");
  add_shard(*command, options->shard, options->json_file);
  command->add_option("--jobs", options->jobs, "Threads, each with its own engine process")
      ->check(any_jobs)
      ->default_str("one a processor, with an engine one");
  command->add_flag("--decisions", options->decisions,
                    "Compare only the decision of robust with the integer oracle, at full speed");
  add_engine(*command, options->engine, options->timeout, "Engine to ask instead of the textbook formulas in double");
  command->callback([=, &action] {
    options->program = command->get_parent()->get_name();
    action = [=] { return exhaust_command(*options, std::cout, std::cerr); };
  });
}

void add_soak(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand(
      "soak", "Robust against the oracle alone, at full speed, in every floating-point environment");
  auto options = std::make_shared<SoakCommand>();
  command->add_option("operations", options->operations, "Operations, separated by commas, or all");
  command->add_option("--seconds", options->seconds, "Time limit of the run; the operations take turns")
      ->check(positive)
      ->default_str("60; with --cases none");
  command->add_option("--cases", options->cases, "Questions per operation, in all shards together")
      ->check(any_cases)
      ->default_str("as many as the time allows");
  command->add_option("--seed", options->seed, "Same seed, same questions")->check(any_seed);
  add_shard(*command, options->shard, options->json_file);
  command->add_option("--jobs", options->jobs, "Threads")->check(any_jobs)->default_str("one a processor");
  command->callback([=, &action] { action = [=] { return soak_command(*options, std::cout, std::cerr); }; });
}

void add_merge(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("merge", "Merges the results of shards, and says which are missing");
  auto options = std::make_shared<MergeCommand>();
  command->add_option("files", options->files, "Results of exhaust, audit or soak --json")->required();
  command->add_option("--json", options->json_file, "Write the sum to this file; - is standard output");
  command->callback([=, &action] { action = [=] { return merge_command(*options, std::cout, std::cerr); }; });
}

void add_vectors(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("vectors", "Test vectors: JSON lines with a schema");
  command->require_subcommand(1);
  auto directory = std::make_shared<std::string>();
  auto operations = std::make_shared<std::string>("all");
  auto seed = std::make_shared<std::uint64_t>(1);
  auto* write = command->add_subcommand("write", "Writes them into a directory");
  write->add_option("directory", *directory, "Output directory")->required();
  write->add_option("--ops", *operations, "Operations, separated by commas, or all");
  write->add_option("--seed", *seed, "Same seed, same vectors")->check(any_seed);
  write->callback([=, &action] {
    action = [=] { return vectors_write_command(*directory, *operations, *seed, std::cout, std::cerr); };
  });
  auto logs = std::make_shared<std::vector<std::string>>();
  auto jobs = std::make_shared<int>(0);
  auto* from = command->add_subcommand("from", "Writes the hardest of recorded calls, made smaller, into a directory");
  from->add_option("logs", *logs, "Logs of recorded calls")->required();
  from->add_option("--to", *directory, "Output directory")->required();
  from->add_option("--ops", *operations, "Operations, separated by commas, or all");
  from->add_option("--jobs", *jobs, "Threads")->check(any_jobs)->default_str("one a processor");
  from->callback([=, &action] {
    action = [=] { return vectors_from_command(*directory, *logs, *operations, *jobs, std::cout); };
  });
  auto* check = command->add_subcommand("check", "Checks certificates, oracle and robust against them");
  auto checked = std::make_shared<VectorsCheckCommand>();
  check->add_option("directory", checked->directory, "Directory of the vectors")->required();
  check->add_option("--ops", checked->operations,
                    "Operations, separated by commas, or all; the manifest is checked only for all");
  add_engine(*check, checked->engine, checked->timeout,
             "Engine that is asked the vectors of its operations and judged; other vectors are not checked");
  auto* engine = check->get_option("--engine");
  check->add_option("--json", checked->json_file, "Write the answers of the engine to this file; - is standard output")
      ->needs(engine);
  check->add_option("--junit", checked->junit_file, "Write the same as JUnit's XML into this file")->needs(engine);
  check->add_flag("--verbose", checked->verbose,
                  "Print every finding of the engine, not only the first ten of each file");
  check->callback([=, &action] {
    checked->program = command->get_parent()->get_name();
    action = [=] { return vectors_check_command(*checked, std::cout, std::cerr); };
  });
}

void add_certify(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("certify", "Re-checks certificates with the small checker alone");
  auto options = std::make_shared<CertifyCommand>();
  command->add_option("file", options->file, "Lines as written by ask or vectors; - is standard input");
  add_file_meshes(*command, options->meshes, options->preparation);
  command->callback([=, &action] { action = [=] { return certify_command(*options, std::cout, std::cerr); }; });
}

void add_map(CLI::App& program, Action& action) {
  auto* command =
      program.add_subcommand("map", "Pictures of where an implementation goes wrong around a degenerate input");
  auto options = std::make_shared<MapCommand>();
  command->add_option("operation", options->operations, "Names of operations")->required();
  command->add_option("--jobs", options->jobs, "Threads")->check(any_jobs)->default_str("one a processor");
  command->add_option("--out", options->directory, "Directory for the pictures");
  command->add_flag("--binary32", options->binary32, "The textbook formula in float instead of double");
  add_engine(*command, options->engine, options->timeout, "Engine whose answers a third map shows");
  command->callback([=, &action] {
    action = [=] {
      options->program = command->get_parent()->get_name();
      for (const std::string& name : options->operations) operation_named(name);
      return run_map(*options);
    };
  });
}

void add_simulate(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("simulate", "A scene in float, in double and by robust, side by side");
  auto options = std::make_shared<SimulateCommand>();
  command->add_option("scene", options->file, "JSON file of the scene (docs/simulate.md)")->required();
  command->add_option("--steps", options->steps, "How many")
      ->check(integer_in_range(0, 1'000'000'000))
      ->default_str("");
  command->add_option("--runs", options->runs, "Any of float, double, robust, separated by commas");
  command->add_option("--trajectory", options->trajectory,
                      "Write each step into this file, CSV if named .csv, else JSON lines; - is standard output");
  command
      ->add_option("--engine", options->engines,
                   "Command of an engine that computes the steps over pipes (docs/simulate.md); repeatable")
      ->allow_extra_args(false)
      ->check(a_command)
      ->default_str("");
  command->add_option("--timeout", options->timeout, "Time limit in seconds for one answer of an engine")
      ->check(positive);
  command->add_flag("--resume", options->resume, "Resume from the last complete line of that file");
  command->add_option("--page", options->page, "Write a page that plays the runs to this file; - is standard output");
  command->callback([=, &action] { action = [=] { return simulate_command(*options, std::cout, std::cerr); }; });
}

void add_deck(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("deck", "The lecture deck as one page that lives");
  auto options = std::make_shared<DeckCommand>();
  command->add_option("--page", options->page, "Write it into this file; - is standard output")->required();
  command->add_option("--scenes", options->scenes, "Directory of the scenes that the page plays")->default_str("");
  command->add_option("--cases", options->cases, "Questions per operation")->check(integer_in_range(1, 1'000'000));
  command->add_option("--jobs", options->jobs, "Threads")->check(any_jobs)->default_str("one a processor");
  command->callback([=, &action] { action = [=] { return deck_command(*options, std::cerr); }; });
}

/// Prints one line, whatever names of files and fields it quotes.
int complained(const std::exception& wrong, int code) {
  std::cerr << "touchstone: " << excerpt(wrong.what(), 2000) << '\n';
  return code;
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  audit::prepare_program();
  audit::use_limb_memory();
  CLI::App program{"touchstone: collision tests held against the exact truth"};
  program.allow_windows_style_options(false);  // a path may begin with a slash there, too
  program.require_subcommand(0, 1);
  program.option_defaults()->always_capture_default();
  program.set_version_flag("--version", version, "Version, compiler and libraries");
  program.footer(std::string("Limits: ") + limits_in_words + "\n\nExit codes: " + exit_codes_in_words);
  bool man = false;
  program.add_flag("--man", man, "Prints the manual page: touchstone --man | man -l -");
  std::string shell;
  program.add_option("--completion", shell, "Prints a script that completes command lines: for bash or zsh");
  Action action;
  for (auto* add :
       {add_ops, add_ask, add_audit, add_check_engine, add_draw, add_exhaust, add_soak, add_merge, add_vectors,
        add_certify, add_map, add_simulate, add_deck, add_mesh, add_log, add_judge, add_reduce})
    add(program, action);
  try {
    require_known_names(program, argc, argv);
    program.parse(argc, argv);
    if (man || !shell.empty()) {
      std::cout << (man ? man_page(program) : completion(program, shell));
      return nothing_found;
    }
    if (!action) throw UsageError("expected a command (see --help)");
    const int code = action();
    if (!std::cout.flush()) throw UsageError("standard output: cannot be written");
    return code;
  } catch (const CLI::Success& shown) {
    return program.exit(shown);
  } catch (const CLI::ParseError& wrong) {
    return complained(UsageError(std::string(wrong.what()) + " (see --help)"), bad_usage);
  } catch (const EngineError& failed) {
    return complained(failed, engine_failed);
  } catch (const std::exception& wrong) {
    return complained(wrong, bad_usage);
  }
}

}  // namespace touchstone::program
