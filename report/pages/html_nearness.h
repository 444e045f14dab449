// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/counting/tally.h"
#include "report/uses.h"

namespace touchstone::report {

/// The distances of an operation's recorded calls from another answer, and the counts that would have been answered
/// otherwise in double, in float and by open sets. Empty if no calls were recorded.
std::string nearness_section(const OperationTally& tally);
/// The same for all operations, one row each.
std::string nearness_of_all(const Tally& tally);

}  // namespace touchstone::report
