// SPDX-License-Identifier: Apache-2.0
#include "program/engine_main.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <vector>

#include "audit/engines/process.h"
#include "audit/engines/serve.h"
#include "audit/platform.h"
#include "audit/shell_quoted.h"
#include "program/commands/commands.h"
#include "program/program.h"

namespace touchstone::program {
namespace {

/// Commands of `touchstone` that take --engine.
constexpr std::array<const char*, 5> commands_with_engine{"audit", "ask", "exhaust", "map", "vectors"};

bool is_one_of(const char* word, const auto& words) {
  return std::any_of(words.begin(), words.end(), [&](const char* other) { return std::strcmp(word, other) == 0; });
}

void introduce(const Served& engine, const std::string& program) {
  std::cout << engine.hello.declaration.engine << ", an engine of touchstone with " << engine.hello.operations.size()
            << (engine.hello.operations.size() == 1 ? " operation:" : " operations:");
  for (const std::string& operation : engine.hello.operations) std::cout << ' ' << operation;
  std::cout << "\n\n  " << program
            << " [OPTIONS]      audits itself; the options are those of touchstone audit, below\n  " << program
            << " --serve        answers over pipes: touchstone audit --engine \"" << program << " --serve\"\n  "
            << program
            << " COMMAND ...    touchstone COMMAND with itself as the engine: ask OP, exhaust OP, map OP,\n  "
            << std::string(program.size(), ' ') << "                vectors check DIR, check-engine\n\n";
}

/// Names separated by commas, in lines of at most 100 characters; those after the first are indented.
std::string listed(const std::string& heading, const std::vector<std::string>& names) {
  constexpr std::size_t widest = 100;
  std::string text, line = heading;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = " " + names[i] + (i + 1 < names.size() ? "," : "");
    if (line.size() + name.size() > widest) {
      text += line + '\n';
      line = "   ";
    }
    line += name;
  }
  return text + line + '\n';
}

/// True for options with which standard output is not a table for people.
bool prints_no_table(int argc, const char* const* argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i], next = i + 1 < argc ? argv[i + 1] : "";
    if (word == "--help" || word == "-h" || word == "--json=-" || (word == "--json" && next == "-")) return true;
  }
  return false;
}

}  // namespace

std::string operations_found(const Served& engine, bool named) {
  std::vector<std::string> found, not_found;
  for (const Operation* operation : all_operations()) {
    if (operation->metadata().is_implementation()) continue;
    (engine.operations.count(operation->name()) != 0 ? found : not_found).push_back(operation->name());
  }
  const std::string all = std::to_string(found.size() + not_found.size());
  const std::string has =
      engine.hello.declaration.engine + " has " + std::to_string(found.size()) + " of " + all + " operations";
  if (!named) {
    const std::string missing = std::to_string(engine.left_out.size());
    return has +
           (engine.left_out.empty()
                ? ""
                : ", " + missing + (missing == "1" ? " overload is" : " overloads are") + " not found") +
           "; --verbose names them\n";
  }
  std::string text = listed(has + ":", found);
  if (!engine.left_out.empty()) text += listed("No overload found:", engine.left_out);
  constexpr std::size_t most_named = 4;
  if (not_found.size() > most_named) {
    text += "No member function of " + std::to_string(not_found.size()) + " other names: touchstone ops lists them\n";
  } else if (!not_found.empty()) {
    text += listed("No member function of these names:", not_found);
  }
  return text;
}

std::string own_engine_command() {
  const std::string self = own_path();
  return self.empty() ? "" : command_word(self) + " --serve";
}

int engine_program(const EngineMembers& members, int argc, const char* const* argv) {
  prepare_program();
  const Served engine = served(members);
  if (argc == 2 && std::strcmp(argv[1], "--serve") == 0) return serve(engine);
  if (std::getenv(started_as_engine) != nullptr) {
    std::cerr << argv[0] << ": started as an engine without --serve; the command is: " << shell_quoted(argv[0])
              << " --serve\n";
    return bad_usage;
  }
  const std::string command = own_engine_command();
  if (command.empty()) {
    std::cerr << argv[0] << ": its own path cannot be read\n";
    return engine_failed;
  }
  std::vector<const char*> arguments{argv[0]};
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  const bool command_named = argc > 1 && argv[1][0] != '-';
  if (!command_named) arguments.insert(arguments.begin() + 1, "audit");
  const bool audits = std::strcmp(arguments[1], "audit") == 0;
  const bool verbose =
      std::any_of(argv, argv + argc, [](const char* word) { return std::string(word) == "--verbose"; });
  if (audits && !prints_no_table(argc, argv)) std::cout << operations_found(engine, verbose) << '\n' << std::flush;
  const std::array<const char*, 2> help{"-h", "--help"};
  const bool helps = argc == 2 && is_one_of(argv[1], help);
  if (helps) introduce(engine, argv[0]);
  if (!helps && std::strcmp(arguments[1], "check-engine") == 0) {
    arguments.push_back(command.c_str());
  } else if (!helps && is_one_of(arguments[1], commands_with_engine)) {
    arguments.push_back("--engine");
    arguments.push_back(command.c_str());
  }
  return run_program(static_cast<int>(arguments.size()), arguments.data());
}

}  // namespace touchstone::program
