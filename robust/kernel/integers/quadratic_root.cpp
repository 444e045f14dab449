// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/integers/quadratic_root.h"

#include <algorithm>

namespace touchstone::robust::kernel {
namespace {

struct Product {
  UInt128 high, low;
};

Product product(UInt128 a, UInt128 b) {
  const auto a0 = static_cast<std::uint64_t>(a), a1 = static_cast<std::uint64_t>(a >> 64);
  const auto b0 = static_cast<std::uint64_t>(b), b1 = static_cast<std::uint64_t>(b >> 64);
  const UInt128 low = static_cast<UInt128>(a0) * b0, high = static_cast<UInt128>(a1) * b1;
  const UInt128 left = static_cast<UInt128>(a1) * b0, right = static_cast<UInt128>(a0) * b1;
  const UInt128 middle = (low >> 64) + static_cast<std::uint64_t>(left) + static_cast<std::uint64_t>(right);
  return {high + (left >> 64) + (right >> 64) + (middle >> 64), middle << 64 | static_cast<std::uint64_t>(low)};
}

std::int64_t digits_of(const mpz_class& n) { return static_cast<std::int64_t>(mpz_sizeinbase(n.get_mpz_t(), 2)); }

/// An e with 2^e <= n + sign sqrt(square), which is positive.
std::int64_t order_below(const mpz_class& n, int sign, const mpz_class& square) {
  const std::int64_t root_digits = (digits_of(square) + 1) / 2;  // 2^(digits - 1) <= root < 2^digits, if it is not 0
  if (sign > 0 && sgn(n) >= 0) return sgn(n) > 0 ? digits_of(n) - 1 : root_digits - 1;
  if (sgn(square) == 0) return digits_of(n) - 1;
  // If the terms have opposite signs: the difference is that of the squares, divided by the sum, which is below 2^(both
  // + 1).
  const mpz_class squares = n * n - square;
  return digits_of(squares) - 1 - (std::max(digits_of(n), root_digits) + 1);
}

}  // namespace

int compare_products(UInt128 a, UInt128 b, UInt128 c, UInt128 d) {
  const Product left = product(a, b), right = product(c, d);
  if (left.high != right.high) return left.high > right.high ? 1 : -1;
  return (left.low > right.low) - (left.low < right.low);
}

int sign_with_root(const mpz_class& n, int sign, const mpz_class& square) {
  if (sgn(square) == 0 || sgn(n) == sign) return sgn(n);
  const mpz_class squared = n * n;
  const int larger = cmp(squared, square);
  return larger > 0 ? sgn(n) : larger < 0 ? sign : 0;
}

double round_quadratic_root(const mpz_class& n, int sign, const mpz_class& square, const mpz_class& d,
                            std::int64_t exponent) {
  const int sign_above = sign_with_root(n, sign, square);
  if (sign_above == 0) return round_scaled(mpz_class(0), 0);
  // The integer part of the magnitude in units of 2^-shift, with at least 65 digits, and whether there is a remainder.
  // Nested floors collapse: dropping the part below a unit before the division changes nothing.
  mpz_class above = sign_above > 0 ? n : mpz_class(-n), below = abs(d), root = square, rest;
  const int root_sign = sign_above > 0 ? sign : -sign;
  const std::int64_t shift = std::max<std::int64_t>(66 + digits_of(below) - order_below(above, root_sign, square), 0);
  root <<= static_cast<std::uint64_t>(2 * shift);
  mpz_sqrtrem(root.get_mpz_t(), rest.get_mpz_t(), root.get_mpz_t());
  bool tail = sgn(rest) != 0;
  above <<= static_cast<std::uint64_t>(shift);
  if (root_sign > 0) above += root;
  else above -= root + (tail ? 1 : 0);
  mpz_tdiv_qr(above.get_mpz_t(), rest.get_mpz_t(), above.get_mpz_t(), below.get_mpz_t());
  tail = tail || sgn(rest) != 0;
  // One extra digit represents the entire remainder: it is below everything that rounding compares.
  mpz_class digits = 2 * above + (tail ? 1 : 0);
  if (sign_above * sgn(d) < 0) digits = -digits;
  return round_scaled(digits, exponent - shift - 1);
}

}  // namespace touchstone::robust::kernel
