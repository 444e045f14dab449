// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

#include "program/terminal/uses.h"

/// Rules for the values of options.
namespace touchstone::program {

/// A number greater than 0. CLI11's own check prints the full range of double.
extern const CLI::Validator positive;
/// An integer in a range; CLI11 alone would report an integer that is out of range as not a number.
CLI::Validator integer_in_range(std::uint64_t least, std::uint64_t most);
extern const CLI::Validator any_seed, any_cases, any_jobs;
/// An unset variable leaves an empty command, which must not audit something else.
extern const CLI::Validator a_command;

/// Adds --engine and --timeout. `what`: describes the use of the engine.
void add_engine(CLI::App& command, std::string& engine, double& timeout, const std::string& what);

}  // namespace touchstone::program
