// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/tally.h"

namespace touchstone::audit {

/// The text that `touchstone audit` prints: counts by operation and family, robust's line, the smallest failing input
/// of each cause with the command that repeats it, inconsistent conventions, one closing sentence. The same tally gives
/// the same bytes.
std::string text_table(const Tally& tally);

}  // namespace touchstone::audit
