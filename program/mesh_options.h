// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

#include "audit/meshes/prepared.h"
#include "program/uses.h"

namespace touchstone::program {

/// Adds --merge, --planar and --cut. Parsing the line sets what they say.
std::vector<CLI::Option*> add_preparation(CLI::App& command, Preparation& how);

/// Adds the command `mesh`. Parsing the line sets the action that runs it.
void add_mesh(CLI::App& program, std::function<int()>& action);

}  // namespace touchstone::program
