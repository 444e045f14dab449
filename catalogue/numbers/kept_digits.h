// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/numbers/exact.h"
#include "catalogue/numbers/tracked.h"

/// The nearest number of 53 binary digits, for formulas whose contract rounds between steps (impact_step).
namespace touchstone::catalogue {

/// Ties to even; the exponent is unbounded.
Exact kept_digits(const Exact& number);

/// The number itself. The exact formula rounds here as well, by at most 2^-53 of its number, which is at most 2^-52 of
/// this one: the bound includes it, unless this one is the exact number, which has no more digits.
Tracked kept_digits(const Tracked& number);

}  // namespace touchstone::catalogue
