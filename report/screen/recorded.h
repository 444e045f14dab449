// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/counting/tally.h"
#include "report/uses.h"

namespace touchstone::report {

/// Printed below the table of recorded calls: by operation and call site the distance of the calls from another answer,
/// and the number that would have been answered otherwise. Empty if no calls were recorded.
std::string recorded_table(const Tally& tally);

}  // namespace touchstone::report
