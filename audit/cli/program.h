// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace touchstone::audit {

/// The program `touchstone`: parses the command line and runs one command. Returns the exit code: 0 nothing found,
/// 1 findings, 2 wrong usage or bad input (one line on stderr), 3 the engine could not be run.
int run_program(int argc, const char* const* argv);

enum ExitCode { nothing_found = 0, findings = 1, bad_usage = 2, engine_failed = 3 };

}  // namespace touchstone::audit
