// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/nearest_double.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "oracle/exact/decode.h"

namespace touchstone::oracle {
namespace {

const std::uint64_t infinity_bits = std::uint64_t{0x7ff} << 52;

/// e with 2^e <= |value| < 2^(e+1); value is not zero.
long binary_order(const Rational& value) {
  const long numerator_bits = static_cast<long>(mpz_sizeinbase(value.get_num_mpz_t(), 2));
  const long denominator_bits = static_cast<long>(mpz_sizeinbase(value.get_den_mpz_t(), 2));
  const long guess = numerator_bits - denominator_bits;  // the order is guess or guess - 1
  Integer scaled_numerator(abs(value.get_num())), scaled_denominator(value.get_den());
  if (guess > 0) {
    scaled_denominator <<= static_cast<mp_bitcnt_t>(guess);
  } else {
    scaled_numerator <<= static_cast<mp_bitcnt_t>(-guess);
  }
  return scaled_numerator >= scaled_denominator ? guess : guess - 1;
}

}  // namespace

int ulp_exponent(const Rational& value) {
  if (sgn(value) == 0) return -1074;
  return static_cast<int>(std::clamp(binary_order(value) - 52, -1074L, 971L));
}

double nearest_double(const Rational& value) {
  if (sgn(value) == 0) return 0.0;
  const std::uint64_t sign = sgn(value) < 0 ? std::uint64_t{1} << 63 : 0;
  if (binary_order(value) >= 1024) return std::bit_cast<double>(sign | infinity_bits);
  const int exponent = ulp_exponent(value);
  const Rational ulps = scaled(Rational(abs(value)), -exponent);
  Integer whole, rest;
  mpz_fdiv_qr(whole.get_mpz_t(), rest.get_mpz_t(), ulps.get_num_mpz_t(), ulps.get_den_mpz_t());
  std::uint64_t mantissa = whole.get_ui();
  const int to_half = cmp(Integer(2 * rest), ulps.get_den());
  if (to_half > 0 || (to_half == 0 && mantissa % 2 == 1)) ++mantissa;
  // The exponent field of a normal number adds to the implicit bit, so a carry moves on to the next binade or infinity.
  const std::uint64_t field = mantissa >> 52 == 0 ? 0 : static_cast<std::uint64_t>(exponent + 1074);
  return std::bit_cast<double>(sign | ((field << 52) + mantissa));
}

Rational rounding_margin(const Rational& value) {
  const int exponent = ulp_exponent(value);
  const Rational ulps = scaled(Rational(abs(value)), -exponent);
  const Integer top = Integer(1) << 53;
  if (ulps >= top) return Rational(ulps - (top - Rational(1, 2)));
  Integer whole;
  mpz_fdiv_q(whole.get_mpz_t(), ulps.get_num_mpz_t(), ulps.get_den_mpz_t());
  const Rational part(ulps - whole);
  Rational margin(abs(part - Rational(1, 2)));
  if (exponent > -1074 && whole == Integer(1) << 52) {  // below a power of two the spacing halves
    const Rational below(part + Rational(1, 4));
    if (below < margin) margin = below;
  }
  return margin;
}

}  // namespace touchstone::oracle
