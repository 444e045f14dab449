// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/counting/tally.h"
#include "report/uses.h"

namespace touchstone::report {

/// A table of truth against answer in words: the count of each answer to each truth. Empty if the truths have no
/// enumerators. `who`: names whose answers they are.
std::string confusion_matrix(const Operation& operation, const Cell& total, const std::string& speaker_name);

}  // namespace touchstone::report
