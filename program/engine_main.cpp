// SPDX-License-Identifier: Apache-2.0
#include "program/engine_main.h"

#include <cstring>
#include <filesystem>
#include <iostream>

#include "program/program.h"

namespace touchstone::audit {
namespace {

std::string quoted_for_shell(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

}  // namespace

int engine_program(const Served& engine, int argc, const char* const* argv) {
  if (argc == 2 && std::strcmp(argv[1], "--serve") == 0) return serve(engine);
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) {
    std::cerr << argv[0] << ": its own path cannot be read: " << error.message() << '\n';
    return engine_failed;
  }
  const std::string command = quoted_for_shell(self.string()) + " --serve";
  std::vector<const char*> arguments{argv[0], "audit", "--engine", command.c_str()};
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  return run_program(static_cast<int>(arguments.size()), arguments.data());
}

}  // namespace touchstone::audit
