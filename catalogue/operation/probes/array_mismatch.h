// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/operation/operation.h"

namespace touchstone::catalogue {

/// What robust answers otherwise where it is asked a question in every row of arrays, a refusal included; empty where
/// it is nothing, or where it does not answer arrays. `decision` is what it answers of the one question. `choice`
/// chooses the number of rows and the instruction set.
std::string array_mismatch(const Operation& operation, const Question& question, Word decision, std::size_t environment,
                           std::uint64_t choice);

/// The same of a question that is refused in these words, "field: rule". Arrays name the row before a field of it, and
/// look at what all rows share before any row.
std::string array_refusal_mismatch(const Operation& operation, const Question& question, const std::string& refusal,
                                   std::size_t environment, std::uint64_t choice);

/// The choice of 70 rows with an instruction set: a chunk of 64 that a second stage looks at where it stands, and six
/// more that are packed for it; what that leaves is decided one by one.
constexpr std::uint64_t choice_of_every_path(robust::batch::Instructions at_most) {
  return 69 + 70 * static_cast<std::uint64_t>(at_most);
}

}  // namespace touchstone::catalogue
