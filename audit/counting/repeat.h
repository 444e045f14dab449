// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/counting/tally.h"

namespace touchstone::audit {

/// The shell command that asks a question again, to a foreign engine or otherwise to our formulas and robust; the input
/// as decimals that read back exactly.
std::string repeat_command(const Operation& operation, const Question& question, const Repeat& repeat, bool foreign);

/// The same for the engine of a tally, or for robust next to it.
std::string repeat_command(const Operation& operation, const Question& question, const Tally& tally, bool of_robust);

}  // namespace touchstone::audit
