// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "program/terminal/exit_codes.h"

namespace touchstone::program {

/// The program `touchstone`: parses the command line and runs one command. Returns the exit code: 0 no findings, 1
/// findings, 2 wrong usage, bad input, or nothing to judge (one line on stderr), 3 the engine could not be run or has
/// none of the operations, 130 interrupted (the counts so far are kept).
int run_program(int argc, const char* const* argv);

}  // namespace touchstone::program
