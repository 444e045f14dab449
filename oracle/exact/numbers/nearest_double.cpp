// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/numbers/nearest_double.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "oracle/exact/numbers/wide.h"

namespace touchstone::oracle {
namespace {

const std::uint64_t infinity_bits = std::uint64_t{0x7ff} << 52;

std::int64_t bit_length(mpz_srcptr value) { return static_cast<std::int64_t>(mpz_sizeinbase(value, 2)); }

bool power_of_two(mpz_srcptr value) { return static_cast<std::int64_t>(mpz_scan1(value, 0)) == bit_length(value) - 1; }

/// |value| = (whole + rest / unit) * 2^exponent, 0 <= rest < unit.
struct Ulps {
  Integer integer, rest, unit;

  Ulps(const Rational& value, int exponent) : rest(abs(value.get_num())), unit(value.get_den()) {
    const auto twos = std::min(static_cast<int>(mpz_scan1(unit.get_mpz_t(), 0)), std::max(-exponent, 0));
    unit >>= static_cast<mp_bitcnt_t>(twos);
    if (const int left = exponent + twos; left >= 0) {
      unit <<= static_cast<mp_bitcnt_t>(left);
    } else {
      rest <<= static_cast<mp_bitcnt_t>(-left);
    }
    mpz_fdiv_qr(integer.get_mpz_t(), rest.get_mpz_t(), rest.get_mpz_t(), unit.get_mpz_t());
  }
};

/// The 64 bits of |value| from `at` on.
std::uint64_t bits_from(mpz_srcptr value, std::int64_t at) {
  const std::uint64_t low = mpz_getlimbn(value, at / 64) >> at % 64;
  return at % 64 == 0 ? low : low | mpz_getlimbn(value, at / 64 + 1) << (64 - at % 64);
}

struct Parts {
  std::uint64_t mantissa;
  int to_half;  // comparison of the rest with a half
};

Parts in_ulps(const Rational& value, int exponent) {
  mpz_srcptr numerator = value.get_num_mpz_t(), denominator = value.get_den_mpz_t();
  if (!power_of_two(denominator)) {
    const Ulps ulps(value, exponent);
    return {ulps.integer.get_ui(), cmp(Integer(2 * ulps.rest), ulps.unit)};
  }
  const std::int64_t dropped = exponent + bit_length(denominator) - 1;  // bits of the numerator below the last place
  if (dropped <= 0) return {mpz_get_ui(numerator) << -dropped, -1};
  const bool half = bits_from(numerator, dropped - 1) % 2 == 1;
  const bool more = static_cast<std::int64_t>(mpz_scan1(numerator, 0)) < dropped - 1;
  return {bits_from(numerator, dropped), half ? more : -1};
}

/// In the interior of a binade, and with the fraction of an ulp in `dropped` bits: the distance from there to the
/// middle.
Rational dyadic_margin(mpz_srcptr numerator, std::int64_t dropped) {
  const auto bits = static_cast<mp_bitcnt_t>(dropped);
  Integer rest, middle;
  mpz_tdiv_r_2exp(rest.get_mpz_t(), numerator, bits);
  mpz_abs(rest.get_mpz_t(), rest.get_mpz_t());
  mpz_setbit(middle.get_mpz_t(), bits - 1);
  middle -= rest;
  return scaled(absolute(middle), -static_cast<int>(dropped));
}

}  // namespace

std::int64_t binary_order(const Rational& value) {
  mpz_srcptr numerator = value.get_num_mpz_t(), denominator = value.get_den_mpz_t();
  const std::int64_t guess = bit_length(numerator) - bit_length(denominator);  // the order is guess or guess - 1
  if (power_of_two(denominator)) return guess;
  Integer above(abs(value.get_num())), below(value.get_den());
  if (guess > 0) {
    below <<= static_cast<mp_bitcnt_t>(guess);
  } else {
    above <<= static_cast<mp_bitcnt_t>(-guess);
  }
  return above >= below ? guess : guess - 1;
}

int ulp_exponent(const Rational& value) {
  if (sgn(value) == 0) return -1074;
  return static_cast<int>(std::clamp<std::int64_t>(binary_order(value) - 52, -1074, 971));
}

double nearest_double(const Rational& value) {
  if (sgn(value) == 0) return 0.0;
  const std::uint64_t sign = sgn(value) < 0 ? std::uint64_t{1} << 63 : 0;
  if (binary_order(value) >= 1024) return std::bit_cast<double>(sign | infinity_bits);
  const int exponent = ulp_exponent(value);
  auto [mantissa, to_half] = in_ulps(value, exponent);
  if (to_half > 0 || (to_half == 0 && mantissa % 2 == 1)) ++mantissa;
  // The exponent field of a normal number adds to the implicit bit, so a carry moves on to the next binade or infinity.
  const std::uint64_t field = mantissa >> 52 == 0 ? 0 : static_cast<std::uint64_t>(exponent + 1074);
  return std::bit_cast<double>(sign | ((field << 52) + mantissa));
}

Rational rounding_margin(const Rational& value) {
  const int exponent = ulp_exponent(value);
  if (mpz_srcptr denominator = value.get_den_mpz_t(); power_of_two(denominator)) {
    const std::int64_t dropped = exponent + bit_length(denominator) - 1;
    mpz_srcptr numerator = value.get_num_mpz_t();
    const bool in_range = bit_length(numerator) - dropped <= 53;
    if (dropped > 0 && in_range && (exponent == -1074 || bits_from(numerator, dropped) != std::uint64_t{1} << 52)) {
      return dyadic_margin(numerator, dropped);
    }
  }
  const Ulps ulps(value, exponent);
  const Integer top = Integer(1) << 53;
  if (ulps.integer >= top) {  // from the largest double on: the distance to the tie with infinity
    const Rational beyond(Rational(ulps.integer - top) + quotient(ulps.rest, ulps.unit));
    return Rational(beyond + Rational(1, 2));
  }
  const Integer doubled(2 * ulps.rest);
  const Rational margin = quotient(Integer(abs(doubled - ulps.unit)), Integer(2 * ulps.unit));
  if (exponent == -1074 || ulps.integer != top / 2) return margin;
  const Rational below =
      quotient(Integer(2 * doubled + ulps.unit), Integer(4 * ulps.unit));  // there the spacing halves
  return std::min(margin, below);
}

}  // namespace touchstone::oracle
