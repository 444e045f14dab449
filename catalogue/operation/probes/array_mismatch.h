// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/operation/operation.h"

namespace touchstone::catalogue {

/// The difference in robust's answers if a question is asked in every row of arrays, including refusals; "" if there is
/// none, or if it does not answer arrays. `decision` is its answer to the single question. `choice` selects the number
/// of rows and the instruction set.
std::string array_mismatch(const Operation& operation, const Question& question, Word decision, std::size_t environment,
                           std::uint64_t choice);

/// The same for a question that is refused with the message "field: rule". Arrays name the row before its field, and
/// check the shared part before any row.
std::string array_refusal_mismatch(const Operation& operation, const Question& question, const std::string& refusal,
                                   std::size_t environment, std::uint64_t choice);

/// The choice of 70 rows with an instruction set: a chunk of 64 that a second stage decides in place, and six more that
/// are packed for it; the rows that it leaves are decided one by one.
constexpr std::uint64_t choice_of_every_path(robust::batch::Instructions at_most) {
  return 69 + 70 * static_cast<std::uint64_t>(at_most);
}

}  // namespace touchstone::catalogue
