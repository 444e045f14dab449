// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "program/command_tree.h"

namespace touchstone::program {

/// Adds the command `log`: logs of recorded calls.
void add_log(CLI::App& program, Action& action);
/// Adds the command `judge`: verdicts on recorded answers.
void add_judge(CLI::App& program, Action& action);

}  // namespace touchstone::program
