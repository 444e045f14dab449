// SPDX-License-Identifier: Apache-2.0
#include "program/documentation.h"

#include <embedded.h>  // made by the build
#include <fmt/ranges.h>

#include <set>

#include "catalogue/codec/did_you_mean.h"
#include "program/command_tree.h"
#include "program/commands/commands.h"

namespace touchstone::program {
namespace {

/// Text of a paragraph, escaped so that no letter of it is an instruction to roff.
std::string roff(const std::string& text) {
  std::string escaped = text[0] == '.' || text[0] == '\'' ? "\\&" : "";
  for (const char c : text) escaped += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  return escaped;
}

/// An application, then every command below it.
std::vector<const CLI::App*> with_commands(const CLI::App& application) {
  std::vector<const CLI::App*> all{&application};
  for (const CLI::App* command : commands_of(application)) {
    const std::vector<const CLI::App*> below = with_commands(*command);
    all.insert(all.end(), below.begin(), below.end());
  }
  return all;
}

std::string options_in_roff(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    const std::string value = option->get_default_str(), name = option->get_name(!option->nonpositional(), true);
    const bool typed = option->nonpositional() && option->get_expected_min() > 0;
    text += ".TP\n.B " + roff(typed ? name + " " + option->get_type_name() : name) + "\n" +
            roff(option->get_description() + (value.empty() ? "" : " [" + value + "]")) + "\n";
  }
  return text;
}

std::string synopsis(const CLI::App& command) {
  std::string text = full_name(command);
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name(true);
    if (!option->nonpositional()) text += option->get_required() ? " " + name : " [" + name + "]";
  }
  return roff(text + " [options]");
}

/// The data for program/completion.bash.
std::string words_for_bash(const CLI::App& program) {
  std::string operations, cases;
  std::set<std::string> values;
  for (const Operation* operation : all_operations()) operations += (operations.empty() ? "" : " ") + operation->name();
  for (const CLI::App* command : with_commands(program)) {
    std::vector<std::string> words = option_names_of(*command);
    for (const CLI::App* below : commands_of(*command)) words.push_back(below->get_name());
    for (const CLI::Option* option : command->get_options()) {
      if (option->get_name(true) == "operation") words.push_back("$_touchstone_operations");
      if (!option->nonpositional() || option->get_expected_min() == 0) continue;
      for (const std::string& name : option->get_lnames()) values.insert("--" + name);
    }
    cases += fmt::format("    \"{}\") echo \"{}\" ;;\n", full_name(*command), fmt::join(words, " "));
  }
  return "# Completes touchstone. Printed by: touchstone --completion\n_touchstone_operations=\"" + operations +
         fmt::format("\"\n_touchstone_values=\"{}\"\n", fmt::join(values, " ")) +
         "_touchstone_words() {\n  case $1 in\n" + cases + "  esac\n}\n";
}

}  // namespace

std::string man_page(const CLI::App& program) {
  const std::string described = program.get_description();  // starts with the name
  std::string synopses, commands;
  for (const CLI::App* command : with_commands(program)) {
    if (!commands_of(*command).empty()) continue;
    synopses += ".B " + synopsis(*command) + "\n.br\n";
    commands +=
        ".SS " + synopsis(*command) + "\n" + roff(command->get_description()) + ".\n" + options_in_roff(*command);
  }
  return ".TH TOUCHSTONE 1 \"\" \"touchstone\" \"User Commands\"\n.SH NAME\ntouchstone \\- " +
         roff(described.substr(described.find(": ") + 2)) + "\n.SH SYNOPSIS\n" + synopses + ".SH OPTIONS\n" +
         options_in_roff(program) + ".SH COMMANDS\n" + commands + ".SH LIMITS\n" + roff(limits_in_words) +
         "\n.SH EXIT STATUS\n" + roff(exit_codes_in_words) +
         "\n.SH ENVIRONMENT\nOutput has no colours, so NO_COLOR changes nothing.\n";
}

std::string completion(const CLI::App& program, const std::string& shell) {
  const std::vector<const char*> shells{"bash", "zsh"};
  if (std::find(shells.begin(), shells.end(), shell) == shells.end())
    throw UsageError("--completion " + shell + ": expected bash or zsh" + did_you_mean(shell, shells));
  return (shell == "zsh" ? "#compdef touchstone\nautoload -U +X bashcompinit && bashcompinit\n" : "") +
         words_for_bash(program) + completion_script;
}

}  // namespace touchstone::program
