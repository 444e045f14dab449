// SPDX-License-Identifier: Apache-2.0
#include "catalogue/numbers/kept_digits.h"

#include <cmath>
#include <cstdint>

#include "catalogue/numbers/ulps.h"

namespace touchstone::catalogue {

Exact kept_digits(const Exact& number) {
  if (!number.defined() || number == Exact(0)) return number;
  const mpq_class value = number.value();
  const auto digits = [](const mpz_class& n) { return static_cast<std::int64_t>(mpz_sizeinbase(n.get_mpz_t(), 2)); };
  // Scaled to between 1/2 and 2, where doubles have 53 digits.
  const std::int64_t order = digits(value.get_num()) - digits(value.get_den());
  const auto shifted = [](const mpq_class& x, std::int64_t by) {
    mpq_class result;
    if (by >= 0) mpq_mul_2exp(result.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(by));
    else mpq_div_2exp(result.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(-by));
    return result;
  };
  return Exact(shifted(exact_value(nearest(shifted(value, -order))), order));
}

Tracked kept_digits(const Tracked& number) {
  if (number.error() == 0 || !std::isfinite(number.value()) || !std::isfinite(number.error())) return number;
  // 0, off by two roundings of 1 / 3 with a bound of 2^-55 each, in double: four of them by 2^-52.
  const Tracked third = Tracked(1) / Tracked(3), doubt = third - third;
  return number + number * (doubt + doubt + doubt + doubt);
}

}  // namespace touchstone::catalogue
