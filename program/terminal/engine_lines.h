// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulate/engine_run.h"

namespace touchstone::program {

/// The lines of a command that the shell runs in a process of its own (docs/simulate.md). It has `timeout` seconds for
/// each answer and 30 more for the first. Lines that do not begin with { are skipped. The process is killed with this
/// object.
std::unique_ptr<simulate::EngineLines> engine_lines(const std::string& command, double timeout);

}  // namespace touchstone::program
