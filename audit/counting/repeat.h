// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/counting/tally.h"

namespace touchstone::audit {

/// The shell line that asks a question again, of a foreign engine or else of our formulas and robust; the input as
/// decimals that read back exactly.
std::string repeat_command(const Operation& operation, const Question& question, const Repeat& repeat, bool foreign);

/// The same of the engine that a tally counts, or of robust next to it.
std::string repeat_command(const Operation& operation, const Question& question, const Tally& tally, bool of_robust);

}  // namespace touchstone::audit
