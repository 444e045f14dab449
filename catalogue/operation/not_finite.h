// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/operation/operation.h"

namespace touchstone::catalogue {

/// A question like `zeros` with small integers, of which one number is `bad`, NaN or an infinity; where a shape before
/// it breaks a rule, the integers are repaired, or the question is the one of the failure map.
Question with_not_finite(const Operation& operation, const Question& zeros, std::size_t place, double bad);

}  // namespace touchstone::catalogue
