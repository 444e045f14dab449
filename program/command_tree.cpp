// SPDX-License-Identifier: Apache-2.0
#include "program/command_tree.h"

#include <algorithm>

#include "catalogue/codec/did_you_mean.h"
#include "program/commands/commands.h"

namespace touchstone::program {
namespace {

const CLI::App* command_named(const CLI::App& application, const std::string& name) {
  for (const CLI::App* command : commands_of(application)) {
    if (command->get_name() == name) return command;
  }
  return nullptr;
}

void refuse_command(const CLI::App& application, const std::string& name) {
  std::vector<std::string> known;
  for (const CLI::App* command : commands_of(application)) known.push_back(command->get_name());
  std::string all;
  for (const std::string& other : known) all += (all.empty() ? "; one of " : ", ") + other;
  throw UsageError(name + ": no command" + did_you_mean(name, known) + all);
}

/// True if the word after it is its value.
bool takes_a_value(const CLI::App& command, const std::string& name) {
  const CLI::Option* const option = command.get_option_no_throw(name);
  return option != nullptr && option->get_expected_min() > 0;
}

}  // namespace

std::vector<const CLI::App*> commands_of(const CLI::App& application) {
  return application.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<std::string> option_names_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::string full_name(const CLI::App& command) {
  return command.get_parent() == nullptr ? "touchstone" : full_name(*command.get_parent()) + " " + command.get_name();
}

void require_known_names(const CLI::App& program, int argc, const char* const* argv) {
  const CLI::App* command = &program;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--") return;
    if (word.size() > 1 && word[0] == '-') {
      const std::size_t equals = word.find('=');
      const std::string name = word.substr(0, equals);
      const std::vector<std::string> known = option_names_of(*command);
      if (std::find(known.begin(), known.end(), name) == known.end()) {
        if (word[1] != '-') continue;  // combined letters, or a value: left to the parser
        throw UsageError(name + ": no option of " + full_name(*command) + did_you_mean(name, known) + " (see --help)");
      }
      if (equals + 1 == word.size()) throw UsageError(name + ": expected a value behind =, got nothing");
      if (equals == std::string::npos && takes_a_value(*command, name)) ++i;
      continue;
    }
    if (commands_of(*command).empty()) continue;
    const CLI::App* const named = command_named(*command, word);
    if (named == nullptr) refuse_command(*command, word);
    command = named;
  }
}

}  // namespace touchstone::program
