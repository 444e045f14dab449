// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/numbers/nearest_float.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "oracle/exact/numbers/decode.h"
#include "oracle/exact/numbers/nearest_double.h"

namespace touchstone::oracle {

float nearest_float(const Rational& value) {
  if (sgn(value) == 0) return 0.0F;
  const std::uint32_t sign = sgn(value) < 0 ? std::uint32_t{1} << 31 : 0, infinite = std::uint32_t{0xff} << 23;
  const std::int64_t order = binary_order(value);
  if (order >= 128) return std::bit_cast<float>(sign | infinite);
  const int exponent = static_cast<int>(std::max<std::int64_t>(order - 23, -149));
  const Rational ulps = scaled(Rational(abs(value)), -exponent);
  Integer integer(ulps.get_num() / ulps.get_den());
  const int to_half = cmp(Rational(ulps - Rational(integer)), Rational(1, 2));
  if (to_half > 0 || (to_half == 0 && mpz_odd_p(integer.get_mpz_t()) != 0)) ++integer;
  const auto mantissa = static_cast<std::uint32_t>(integer.get_ui());
  // The exponent field of a normal number adds to the implicit bit, so a carry moves on to the next binade or infinity.
  const std::uint32_t field = mantissa >> 23 == 0 ? 0 : static_cast<std::uint32_t>(exponent + 149);
  return std::bit_cast<float>(sign | ((field << 23) + mantissa));
}

}  // namespace touchstone::oracle
