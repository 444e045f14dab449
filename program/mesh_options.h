// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

#include "audit/meshes/prepared.h"
#include "program/terminal/uses.h"

namespace touchstone::program {

/// Adds --mesh, with --merge, --planar and --cut. Parsing the line sets their values.
CLI::Option* add_file_meshes(CLI::App& command, std::vector<std::string>& named, Preparation& how);

/// Adds the command `mesh`. Parsing the line sets the action that runs it.
void add_mesh(CLI::App& program, std::function<int()>& action);

}  // namespace touchstone::program
