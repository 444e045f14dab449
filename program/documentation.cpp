// SPDX-License-Identifier: Apache-2.0
#include "program/documentation.h"

#include <set>

#include "catalogue/codec/did_you_mean.h"
#include "program/command_tree.h"
#include "program/commands.h"

namespace touchstone::audit {
namespace {

/// Text of a paragraph: no letter of it is an instruction to roff.
std::string roff(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\\') escaped += "\\e";
    else if (c == '-') escaped += "\\-";
    else escaped += c;
  }
  return !escaped.empty() && (escaped[0] == '.' || escaped[0] == '\'') ? "\\&" + escaped : escaped;
}

bool takes_a_value(const CLI::Option& option) { return option.get_expected_min() > 0; }

/// "--seed WHOLE", "-h,--help"
std::string spelled(const CLI::Option& option) {
  std::string text;
  for (const std::string& name : option.get_snames()) text += (text.empty() ? "-" : ",-") + name;
  for (const std::string& name : option.get_lnames()) text += (text.empty() ? "--" : ",--") + name;
  return text + (takes_a_value(option) ? " " + option.get_type_name() : "");
}

std::string described(const CLI::Option& option) {
  const std::string value = option.get_default_str();
  return option.get_description() + (value.empty() ? "" : " [" + value + "]");
}

std::string options_in_roff(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    const bool positional = !option->nonpositional();
    text += ".TP\n.B " + roff(positional ? option->get_name(true) : spelled(*option)) + "\n" +
            roff(described(*option)) + "\n";
  }
  return text;
}

std::string synopsis(const CLI::App& command) {
  std::string text = full_name(command);
  for (const CLI::Option* option : command.get_options()) {
    if (!option->nonpositional())
      text += option->get_required() ? " " + option->get_name(true) : " [" + option->get_name(true) + "]";
  }
  return text + " [options]";
}

/// Every command that does something, with its full name.
std::vector<const CLI::App*> leaves_of(const CLI::App& application) {
  std::vector<const CLI::App*> leaves;
  for (const CLI::App* command : commands_of(application)) {
    const std::vector<const CLI::App*> below = leaves_of(*command);
    if (below.empty()) leaves.push_back(command);
    leaves.insert(leaves.end(), below.begin(), below.end());
  }
  return leaves;
}

/// Whether what is typed there is the name of an operation, or names with commas.
bool names_operations(const CLI::Option& option) {
  return option.get_name(true) == "operation" || option.check_lname("ops");
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// What may follow a command: its commands and options.
std::string words_after(const CLI::App& command) {
  std::vector<std::string> words;
  for (const CLI::App* below : commands_of(command)) words.push_back(below->get_name());
  for (const std::string& name : option_names_of(command)) words.push_back(name);
  return joined(words);
}

void add_cases(const CLI::App& command, const std::string& path, std::string& words, std::string& operations) {
  words += "    \"" + path + "\") words=\"" + words_after(command) + "\" ;;\n";
  for (const CLI::Option* option : command.get_options()) {
    if (!option->nonpositional() && names_operations(*option))
      operations += "    \"" + path + "\") words=\"$words $operations\" ;;\n";
  }
  for (const CLI::App* below : commands_of(command))
    add_cases(*below, path.empty() ? below->get_name() : path + " " + below->get_name(), words, operations);
}

/// "    --seed | --json": every option of any command that takes a value, but the names of operations.
std::string value_options(const CLI::App& program) {
  std::set<std::string> names;
  const auto add = [&](const auto& self, const CLI::App& command) -> void {
    for (const CLI::Option* option : command.get_options()) {
      if (!takes_a_value(*option) || names_operations(*option)) continue;
      for (const std::string& name : option->get_lnames()) names.insert("--" + name);
    }
    for (const CLI::App* below : commands_of(command)) self(self, *below);
  };
  add(add, program);
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "    " : " | ") + name;
  return text;
}

std::string bash_completion(const CLI::App& program) {
  std::string names, words, operations;
  for (const Operation* operation : catalogue()) names += (names.empty() ? "" : " ") + operation->name();
  add_cases(program, "", words, operations);
  return R"(# Completes touchstone. Printed by: touchstone --completion bash
_touchstone() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} path="" word words="" i
  local operations=")" +
         names + R"("
  for ((i = 1; i < COMP_CWORD; i++)); do
    word=${COMP_WORDS[i]}
    case "${path:+$path }$word" in
)" +
         [&] {
           std::string patterns;
           const auto add = [&](const auto& self, const CLI::App& command, const std::string& path) -> void {
             for (const CLI::App* below : commands_of(command)) {
               const std::string name = path.empty() ? below->get_name() : path + " " + below->get_name();
               patterns += (patterns.empty() ? "    \"" : " | \"") + name + "\"";
               self(self, *below, name);
             }
           };
           add(add, program, "");
           return patterns;
         }() +
         R"() path="${path:+$path }$word" ;;
    esac
  done
  COMPREPLY=()
  case $previous in
    --ops)
      # Names with commas: the last one is completed.
      local before=""
      case $current in *,*) before="${current%,*}," ;; esac
      COMPREPLY=($(compgen -P "$before" -W "all $operations" -- "${current##*,}"))
      return
      ;;
)" + value_options(program) +
         R"() return ;;  # a value: bash's own completion, of files
  esac
  case $path in
)" + words +
         R"(  esac
  case $path in
)" + operations +
         R"(  esac
  COMPREPLY=($(compgen -W "$words" -- "$current"))
}
complete -o default -F _touchstone touchstone
)";
}

}  // namespace

const char* limits_in_words() {
  return "An engine has twice --timeout for its first line and --timeout for each answer; 256\n"
         "questions are in flight. 12 answers that do not come, 100 restarts in an operation\n"
         "or 20 in a row end that operation. An answer's line has at most 1 MiB; JSON is\n"
         "nested at most 64 deep; of an answer 4,096 characters are kept, of a name 200.";
}

const char* exit_codes_in_words() {
  return "0 nothing found, 1 findings, 2 wrong usage, bad input or nothing to judge, 3 the\n"
         "engine could not be run, 130 interrupted.";
}

std::string man_page(const CLI::App& program) {
  const std::string described = program.get_description();  // begins with the name
  std::string text = ".TH TOUCHSTONE 1 \"\" \"touchstone\" \"User Commands\"\n.SH NAME\ntouchstone \\- " +
                     roff(described.substr(described.find(": ") + 2)) + "\n.SH SYNOPSIS\n";
  const std::vector<const CLI::App*> leaves = leaves_of(program);
  for (const CLI::App* command : leaves) text += ".B " + roff(synopsis(*command)) + "\n.br\n";
  text += ".SH OPTIONS\n" + options_in_roff(program) + ".SH COMMANDS\n";
  for (const CLI::App* command : leaves) {
    text +=
        ".SS " + roff(synopsis(*command)) + "\n" + roff(command->get_description()) + ".\n" + options_in_roff(*command);
  }
  return text + ".SH LIMITS\n" + roff(limits_in_words()) + "\n.SH EXIT STATUS\n" + roff(exit_codes_in_words()) +
         "\n.SH ENVIRONMENT\nOutput has no colours, so NO_COLOR changes nothing.\n";
}

std::string completion(const CLI::App& program, const std::string& shell) {
  if (shell == "bash") return bash_completion(program);
  if (shell == "zsh") {
    return "#compdef touchstone\n# Printed by: touchstone --completion zsh\nautoload -U +X bashcompinit && "
           "bashcompinit\n" +
           bash_completion(program);
  }
  throw UsageError("--completion " + shell + ": expected bash or zsh" +
                   did_you_mean(shell, std::vector<const char*>{"bash", "zsh"}));
}

}  // namespace touchstone::audit
