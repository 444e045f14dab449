// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "program/terminal/uses.h"

/// The documentation of the program, generated from the same tree of commands and options as --help.
namespace touchstone::program {

/// Printed below every help.
constexpr const char* limits_in_words =
    "An engine has twice --timeout for its first line and --timeout for each answer; 256\n"
    "questions are in flight. 12 answers that do not come, 100 restarts in an operation\n"
    "or 20 in a row end that operation. An answer's line has at most 1 MiB; JSON is\n"
    "nested at most 64 deep, an object has at most 1,000 fields; of an answer 4,096\n"
    "characters are kept, of a name 200. A mesh file is a regular file of at most 256 MiB.";
constexpr const char* exit_codes_in_words =
    "0 nothing found, 1 findings, 2 wrong usage, bad input or nothing to judge, 3 the\n"
    "engine could not be run, 130 interrupted.";

/// The manual page touchstone(1), in roff.
std::string man_page(const CLI::App& program);

/// A script that completes commands, options, names of operations and files: for "bash" or "zsh". Throws UsageError for
/// another shell.
std::string completion(const CLI::App& program, const std::string& shell);

/// "touchstone 0.1.0 (2026-11-28)", then the compiler and the libraries, one line each.
std::string version();

}  // namespace touchstone::program
