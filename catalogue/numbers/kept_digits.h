// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/numbers/exact.h"
#include "catalogue/numbers/tracked.h"

/// The nearest number of 53 binary digits, for formulas whose contract rounds between steps (impact_step).
namespace touchstone::catalogue {

/// Ties to even; the exponent is unbounded.
Exact kept_digits(const Exact& number);

/// The number itself, in Float. The exact formula rounds here as well, by at most 2^-53 of its number, which is at most
/// 2^-52 of this one: the bound includes it, unless this one is the exact number, which has no more digits.
template <class Float>
Tracked<Float> kept_digits(const Tracked<Float>& number) {
  if (number.error() == 0 || !std::isfinite(number.value()) || !std::isfinite(number.error())) return number;
  // 0, off by two roundings of 1 / 3 with a bound of 2^-55 each, in double: four of them by 2^-52.
  const Tracked<Float> third = Tracked<Float>(1) / Tracked<Float>(3), doubt = third - third;
  return number + number * (doubt + doubt + doubt + doubt);
}

}  // namespace touchstone::catalogue
