// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/counting/tally.h"
#include "report/uses.h"

namespace touchstone::report {

/// The subject of the audit and its settings, with an empty line after it; and robust's answers to the same questions.
std::string heading(const Tally& tally);
std::string robust_line(const Tally& tally);

/// The level of detail.
enum class Detail {
  all,
  operations,  ///< a row for each operation, no families and no examples
};

/// The text that `touchstone audit` prints: counts by operation and family, ordinary and extreme questions separately
/// if there are both; robust's line; for each operation the most frequent wrong outcomes, at ordinary magnitude first,
/// with an example and the command that repeats it; inconsistent conventions; one closing sentence. The same tally
/// gives the same bytes.
std::string text_table(const Tally& tally, Detail detail = Detail::all);

}  // namespace touchstone::report
