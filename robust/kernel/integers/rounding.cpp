// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/integers/rounding.h"

#include <limits>

namespace touchstone::robust::kernel {
namespace {

constexpr int precision = 53, max_exponent = 1023, min_exponent = -1022, least_exponent = -1074;

double assemble(bool negative, std::uint64_t bits) {
  return std::bit_cast<double>(bits | static_cast<std::uint64_t>(negative) << 63);
}

constexpr std::uint64_t infinity_bits = std::uint64_t{0x7ff} << 52;

struct Division {
  std::uint64_t digits;
  bool remainder;
};

/// (n2 2^128 + n1 2^64 + n0) / d, where n2 < 2^63 and d >= 2^127: the quotient is below 2^64.
Division divide(std::uint64_t n2, std::uint64_t n1, std::uint64_t n0, UInt128 d) {
  const auto d1 = static_cast<std::uint64_t>(d >> 64), d0 = static_cast<std::uint64_t>(d);
  const UInt128 high = static_cast<UInt128>(n2) << 64 | n1;
  auto digit = static_cast<std::uint64_t>(high / d1);
  UInt128 rest = (high - static_cast<UInt128>(digit) * d1) << 64 | n0;
  UInt128 product = static_cast<UInt128>(digit) * d0;
  // Dividing by the upper half alone overshoots by at most 2 (d1 has its highest bit set).
  while (rest < product) {
    --digit;
    product -= d0;
    const UInt128 more = rest + (static_cast<UInt128>(d1) << 64);
    if (more < rest) return {digit, true};  // past 2^128, so certainly above product
    rest = more;
  }
  return {digit, rest != product};
}

/// n / d * 2^exponent for magnitudes, n and d not zero.
double round_magnitudes(bool negative, std::array<std::uint64_t, 3> n, UInt128 d, std::int64_t exponent) {
  const int d_shift = d >> 64 ? std::countl_zero(static_cast<std::uint64_t>(d >> 64))
                              : 64 + std::countl_zero(static_cast<std::uint64_t>(d));
  d <<= d_shift;
  int n_shift = -1;  // n becomes 191 bits long
  while (n[2] == 0) n = {0, n[0], n[1]}, n_shift += 64;
  const int rest = std::countl_zero(n[2]);
  n_shift += rest;
  bool lost = false;
  if (rest == 0) {
    lost = n[0] & 1;
    n = {n[0] >> 1 | n[1] << 63, n[1] >> 1 | n[2] << 63, n[2] >> 1};
  } else if (rest > 1) {
    const int left = rest - 1, right = 64 - left;
    n = {n[0] << left, n[1] << left | n[0] >> right, n[2] << left | n[1] >> right};
  }
  // n in [2^190, 2^191) and d in [2^127, 2^128): the quotient lies in (2^62, 2^64).
  const Division q = divide(n[2], n[1], n[0], d);
  const int zeros = std::countl_zero(q.digits);
  const bool tail = q.remainder || lost;
  const std::int64_t scale = exponent - n_shift + d_shift;
  if (zeros == 0) return round_leading(negative, q.digits, tail, scale);
  // At most one leading zero. The digit shifted in is 0, and the tail may reach it without effect on the rounding,
  // which examines 54 digits and whether anything follows.
  return round_leading(negative, q.digits << 1, tail, scale - 1);
}

struct Leading {
  std::uint64_t digits;
  bool tail;
  std::int64_t shift;
};

/// The upper 64 digits of n > 0: n = (digits + tail) * 2^shift.
Leading leading_of(const mpz_class& n) {
  const auto length = static_cast<std::int64_t>(mpz_sizeinbase(n.get_mpz_t(), 2));
  mpz_class top;
  if (length <= 64) {
    top = n << static_cast<std::uint64_t>(64 - length);
    return {mpz_get_ui(top.get_mpz_t()), false, length - 64};
  }
  const auto shift = static_cast<std::uint64_t>(length - 64);
  top = n >> shift;
  return {mpz_get_ui(top.get_mpz_t()), mpz_scan1(n.get_mpz_t(), 0) < shift, length - 64};
}

}  // namespace

double round_leading(bool negative, std::uint64_t leading, bool tail, std::int64_t exponent) {
  const std::int64_t top = exponent + 63;  // the number lies in [2^top, 2^(top + 1))
  if (top > max_exponent) return assemble(negative, infinity_bits);
  const std::int64_t digits = top >= min_exponent ? precision : top - least_exponent + 1;
  if (digits < 0) return assemble(negative, 0);
  const auto drop = static_cast<int>(64 - digits);  // 11 to 64
  const std::uint64_t kept = drop == 64 ? 0 : leading >> drop;
  const std::uint64_t dropped = drop == 64 ? leading : leading & ((std::uint64_t{1} << drop) - 1);
  const std::uint64_t half = std::uint64_t{1} << (drop - 1);
  const bool up = dropped > half || (dropped == half && (tail || (kept & 1)));
  // A carry out of the fraction goes into the exponent field, as required; at the top it makes infinity.
  const std::uint64_t field = top >= min_exponent ? static_cast<std::uint64_t>(top - min_exponent) << 52 : 0;
  return assemble(negative, field + kept + up);
}

double round_scaled(Int128 n, std::int64_t exponent) {
  if (n == 0) return assemble(false, 0);
  const UInt128 size = magnitude_of(n);
  const auto high = static_cast<std::uint64_t>(size >> 64), low = static_cast<std::uint64_t>(size);
  if (high == 0) {
    const int zeros = std::countl_zero(low);
    return round_leading(n < 0, low << zeros, false, exponent - zeros);
  }
  const int zeros = std::countl_zero(high);
  const UInt128 shifted = size << zeros;
  return round_leading(n < 0, static_cast<std::uint64_t>(shifted >> 64), static_cast<std::uint64_t>(shifted) != 0,
                       exponent + 64 - zeros);
}

double round_scaled(const mpz_class& n, std::int64_t exponent) {
  if (sgn(n) == 0) return assemble(false, 0);
  const mpz_class size = abs(n);
  const Leading top = leading_of(size);
  return round_leading(sgn(n) < 0, top.digits, top.tail, exponent + top.shift);
}

double round_quotient(Int128 n, Int128 d, std::int64_t exponent) {
  if (n == 0) return assemble(false, 0);
  const UInt128 size = magnitude_of(n);
  return round_magnitudes((n < 0) != (d < 0),
                          {static_cast<std::uint64_t>(size), static_cast<std::uint64_t>(size >> 64), 0},
                          magnitude_of(d), exponent);
}

double round_quotient(const Int192& n, Int128 d, std::int64_t exponent) {
  const int sign = sign_of(n);
  if (sign == 0) return assemble(false, 0);
  return round_magnitudes((sign < 0) != (d < 0), (sign < 0 ? -n : n).limb, magnitude_of(d), exponent);
}

double round_quotient(const mpz_class& n, const mpz_class& d, std::int64_t exponent) {
  if (sgn(n) == 0) return assemble(false, 0);
  mpz_class above = abs(n), below = abs(d), remainder;
  const auto shift = 65 - static_cast<std::int64_t>(mpz_sizeinbase(n.get_mpz_t(), 2)) +
                     static_cast<std::int64_t>(mpz_sizeinbase(d.get_mpz_t(), 2));
  if (shift >= 0) above <<= static_cast<std::uint64_t>(shift);
  else below <<= static_cast<std::uint64_t>(-shift);
  mpz_tdiv_qr(above.get_mpz_t(), remainder.get_mpz_t(), above.get_mpz_t(), below.get_mpz_t());
  const Leading top = leading_of(above);
  return round_leading((sgn(n) < 0) != (sgn(d) < 0), top.digits, top.tail || sgn(remainder) != 0,
                       exponent - shift + top.shift);
}

double round_square_root(const mpz_class& n, const mpz_class& d, std::int64_t exponent) {
  if (sgn(n) == 0) return assemble(false, 0);
  mpz_class above = abs(n), below = abs(d), division_rest, root_rest;
  // The root of a number of at least 131 digits has at least 66.
  std::int64_t shift = 131 - static_cast<std::int64_t>(mpz_sizeinbase(n.get_mpz_t(), 2)) +
                       static_cast<std::int64_t>(mpz_sizeinbase(d.get_mpz_t(), 2));
  shift += (exponent - shift) & 1;
  if (shift >= 0) above <<= static_cast<std::uint64_t>(shift);
  else below <<= static_cast<std::uint64_t>(-shift);
  mpz_tdiv_qr(above.get_mpz_t(), division_rest.get_mpz_t(), above.get_mpz_t(), below.get_mpz_t());
  // The integer part of a root is the root of the integer part.
  mpz_sqrtrem(above.get_mpz_t(), root_rest.get_mpz_t(), above.get_mpz_t());
  const Leading top = leading_of(above);
  const bool tail = top.tail || sgn(division_rest) != 0 || sgn(root_rest) != 0;
  return round_leading(false, top.digits, tail, (exponent - shift) / 2 + top.shift);
}

double with_sign(double size, int sign) { return assemble(sign < 0, std::bit_cast<std::uint64_t>(size)); }

}  // namespace touchstone::robust::kernel
