// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "program/command_tree.h"

namespace touchstone::program {

/// What `log` is asked: logs of recorded calls.
void add_log(CLI::App& program, Action& action);

}  // namespace touchstone::program
