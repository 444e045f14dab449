// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

#include "program/terminal/uses.h"

/// What the values of options have to be.
namespace touchstone::program {

/// A number greater than 0. CLI11's own check prints the whole range of double.
extern const CLI::Validator positive;
/// An integer in a range; CLI11 alone would take what it cannot hold for no number at all.
CLI::Validator whole(std::uint64_t least, std::uint64_t most);
extern const CLI::Validator any_seed, any_cases, any_jobs;
/// A variable that is not set leaves an empty command, which must not audit something else.
extern const CLI::Validator a_command;

/// Adds --engine and --timeout. `what`: what becomes of the engine.
void add_engine(CLI::App& command, std::string& engine, double& timeout, const std::string& what);

}  // namespace touchstone::program
