// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "program/command_tree.h"

namespace touchstone::program {

/// What `log` is asked: logs of recorded calls.
void add_log(CLI::App& program, Action& action);
/// What `judge` is asked: whether recorded answers are right.
void add_judge(CLI::App& program, Action& action);

}  // namespace touchstone::program
