// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/counting/tally.h"
#include "report/uses.h"

namespace touchstone::report {

/// A table of truth against answer in words: how often what was true was answered how. Empty where the truths have no
/// words. `who`: whose answers they are.
std::string confusion_matrix(const Operation& operation, const Cell& total, const std::string& who);

}  // namespace touchstone::report
