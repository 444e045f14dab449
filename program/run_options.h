// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "program/runs/audit_gate.h"

/// Options of commands that count many answers.
namespace touchstone::program {

/// Adds the options of `audit` for CI.
void add_gate(CLI::App& command, GateCommand& gate);

/// Adds the options that divide a run and name its result.
void add_shard(CLI::App& command, std::string& shard, std::string& json_file);

}  // namespace touchstone::program
