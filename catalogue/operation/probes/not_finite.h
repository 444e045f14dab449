// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "catalogue/operation/operation.h"

namespace touchstone::catalogue {

/// A question like `zeros` with small integers, one number of which is `bad`, NaN or an infinity; if a shape before it
/// breaks a rule, the integers are repaired, or the question is that of the failure map.
Question with_not_finite(const Operation& operation, const Question& zeros, std::size_t place, double bad);

/// If that question breaks another rule too: one of the family "random" that breaks no other, which a filter that
/// forgets the number would answer. nullopt if none of a few draws works.
std::optional<Question> with_only_not_finite(const Operation& operation, const Question& zeros, std::size_t place,
                                             double bad);

}  // namespace touchstone::catalogue
