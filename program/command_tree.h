// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "program/terminal/uses.h"

/// The commands and options of the program as data.
namespace touchstone::program {

/// Runs a command once the line is parsed.
using Action = std::function<int()>;

/// The commands below an application, in the order in which they were added.
std::vector<const CLI::App*> commands_of(const CLI::App& application);

/// All spellings of the options of a command: "--seed", "-h", "--help".
std::vector<std::string> option_names_of(const CLI::App& command);

/// "touchstone vectors write"
std::string full_name(const CLI::App& command);

/// Throws UsageError if the line names an unknown command or option, with the one that was probably meant, or gives an
/// option an empty value after an equals sign.
void require_known_names(const CLI::App& program, int argc, const char* const* argv);

}  // namespace touchstone::program
