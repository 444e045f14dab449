// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "catalogue/operation/operation.h"

namespace touchstone::catalogue {

/// A question like `zeros` with small integers, of which one number is `bad`, NaN or an infinity; where a shape before
/// it breaks a rule, the integers are repaired, or the question is the one of the failure map.
Question with_not_finite(const Operation& operation, const Question& zeros, std::size_t place, double bad);

/// Where that question breaks another rule too: one of the family "random" that breaks no other, which a filter that
/// forgets the number would answer. Nothing where none of a few draws will do.
std::optional<Question> with_only_not_finite(const Operation& operation, const Question& zeros, std::size_t place,
                                             double bad);

}  // namespace touchstone::catalogue
