// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>

/// What documents the program, from the same tree of commands and options as --help.
namespace touchstone::audit {

/// Below every help.
const char* limits_in_words();
const char* exit_codes_in_words();

/// The manual page touchstone(1), in roff.
std::string man_page(const CLI::App& program);

/// A script that completes commands, options, names of operations and files: for "bash" or "zsh". Throws UsageError for
/// another shell.
std::string completion(const CLI::App& program, const std::string& shell);

/// "touchstone 0.1.0", then the compiler and the libraries, a line each.
std::string version();

}  // namespace touchstone::audit
