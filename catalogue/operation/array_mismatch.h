// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/operation/operation.h"

namespace touchstone::catalogue {

/// What robust answers otherwise where it is asked a question in every row of arrays; empty where it is nothing, or
/// where it does not answer arrays. `decision` is what it answers of the one question. `choice` chooses the number of
/// rows and the instruction set.
std::string array_mismatch(const Operation& operation, const Question& question, Word decision,
                           std::size_t environment, std::uint64_t choice);

}  // namespace touchstone::catalogue
