// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/counting/tally.h"
#include "report/uses.h"

namespace touchstone::report {

/// Below the table of recorded calls: by operation and call site how near the calls were to another answer, and how
/// many would have been answered otherwise. Empty where no calls were recorded.
std::string recorded_table(const Tally& tally);

}  // namespace touchstone::report
