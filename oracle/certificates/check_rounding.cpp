// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_rounding.h"

#include <algorithm>
#include <cstdint>

namespace touchstone::certify {
namespace {

using Integer = mpz_class;

/// The exponent of the unit in the last place of a binary64 number near a value that is not 0.
std::int64_t ulp_exponent(const Rational& value) {
  const Rational size(abs(value));
  std::int64_t order = static_cast<std::int64_t>(mpz_sizeinbase(size.get_num_mpz_t(), 2)) -
                       static_cast<std::int64_t>(mpz_sizeinbase(size.get_den_mpz_t(), 2));
  const Rational power = order >= 0 ? Rational(Integer(1) << static_cast<mp_bitcnt_t>(order))
                                    : Rational(1, Integer(1) << static_cast<mp_bitcnt_t>(-order));
  if (size < power) --order;
  return std::clamp<std::int64_t>(order - 52, -1074, 971);
}

/// The nearest integer, ties to even; everything from 2^53 on is infinite alike.
Integer nearest_integer(const Rational& ulps) {
  const Rational size(abs(ulps));
  const Integer integer(size.get_num() / size.get_den());
  const int to_half = cmp(Rational(size - integer), Rational(1, 2));
  const Integer up(to_half > 0 || (to_half == 0 && mpz_odd_p(integer.get_mpz_t())) ? 1 : 0);
  return std::min(Integer(integer + up), Integer(Integer(1) << 53));
}

}  // namespace

void expect_rounds_alike(const std::string& name, const Rational& claimed, const Rational& low, const Rational& high) {
  expect(sgn(claimed) != 0 && sgn(low) == sgn(claimed) && sgn(high) == sgn(claimed),
         "truth: the sign of " + name + " is not proved");
  const std::int64_t exponent = ulp_exponent(claimed);
  const Rational ulp = exponent >= 0 ? Rational(Integer(1) << static_cast<mp_bitcnt_t>(exponent))
                                     : Rational(1, Integer(1) << static_cast<mp_bitcnt_t>(-exponent));
  const Rational close(ulp / Rational(Integer(1) << 60));
  expect(claimed - low < close && high - claimed < close, "truth: " + name + " is too far off");
  const Integer nearest = nearest_integer(claimed / ulp);
  expect(nearest_integer(low / ulp) == nearest && nearest_integer(high / ulp) == nearest,
         "truth: the rounding of " + name + " is not proved");
  expect(low <= claimed && claimed <= high, "truth: " + name + " is not between its bounds");
}

}  // namespace touchstone::certify
