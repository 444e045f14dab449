// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "program/terminal/uses.h"

namespace touchstone::program {

/// Adds the command `reduce`. Parsing the line sets the action that runs it.
void add_reduce(CLI::App& program, std::function<int()>& action);

}  // namespace touchstone::program
