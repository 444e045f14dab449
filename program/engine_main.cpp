// SPDX-License-Identifier: Apache-2.0
#include "program/engine_main.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>

#include "audit/engines/process.h"
#include "audit/shell_quoted.h"
#include "program/commands.h"
#include "program/program.h"

namespace touchstone::audit {
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

}  // namespace

std::string own_engine_command() {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? "" : shell_quoted(self.string()) + " --serve";
}

int engine_program(const Served& engine, int argc, const char* const* argv) {
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

}  // namespace touchstone::audit
