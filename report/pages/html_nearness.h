// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/counting/tally.h"
#include "report/uses.h"

namespace touchstone::report {

/// How near the recorded calls of an operation were to another answer, and which would have been answered otherwise in
/// double, in float and by open sets. Empty where no calls were recorded.
std::string nearness_section(const OperationTally& tally);
/// The same of all operations, a row each.
std::string nearness_of_all(const Tally& tally);

}  // namespace touchstone::report
