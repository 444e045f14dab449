// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/tally.h"

namespace touchstone::audit {

/// The shell line that asks a question again, of an engine that was audited or, where there was none, of our formulas
/// and robust; the input as decimals that read back exactly.
std::string repeat_command(const Operation& operation, const Question& question, const Tally& tally,
                           bool of_robust = false);

}  // namespace touchstone::audit
