// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/square_root.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "oracle/exact/decode.h"
#include "oracle/exact/nearest_double.h"

namespace touchstone::oracle {
namespace {

const int closeness = 60;

bool same_double(const Rational& a, const Rational& b) {
  return std::bit_cast<std::uint64_t>(nearest_double(a)) == std::bit_cast<std::uint64_t>(nearest_double(b));
}

/// The rational root, where there is one: that its square is the number is checked here. Otherwise 0 for a square above
/// 0.
Rational rational_root(const Rational& square) {
  const Rational root(Integer(sqrt(square.get_num())), Integer(sqrt(square.get_den())));
  return root * root == square ? root : Rational(0);
}

/// The greatest multiple of 2^exponent whose square is at most `square`; it has at most `digits` binary digits.
Integer digits_of_root(const Rational& square, int exponent, long digits) {
  const Rational target = scaled(square, -2 * exponent);
  Integer root = 0, squared;
  for (long digit = digits - 1; digit >= 0; --digit) {
    mpz_setbit(root.get_mpz_t(), static_cast<mp_bitcnt_t>(digit));
    squared = root * root * target.get_den();
    if (squared > target.get_num()) mpz_clrbit(root.get_mpz_t(), static_cast<mp_bitcnt_t>(digit));
  }
  return root;
}

}  // namespace

Enclosed signed_root(const Rational& square, int sign) {
  const auto with_sign = [sign](const Rational& size) { return sign < 0 ? Rational(-size) : size; };
  const Rational root = rational_root(square);
  if (root * root == square) return {with_sign(root), with_sign(root), with_sign(root)};
  // 2^order <= square < 2^(order + 1), so the root is below 2^(order / 2 + 1), rounded down.
  const long order = binary_order(square), top = (order >= 0 ? order / 2 : -((1 - order) / 2)) + 1;
  for (long more = closeness + 2;; more *= 2) {
    const long last = std::clamp(top - 53, -1074L, 971L) - more;
    const Integer below = digits_of_root(square, static_cast<int>(last), top - last);
    const Rational low = scaled(below, static_cast<int>(last)),
                   high = scaled(Integer(below + 1), static_cast<int>(last));
    if (sgn(low) == 0 || !same_double(low, high)) continue;
    return sign < 0 ? Enclosed{with_sign(low), with_sign(high), with_sign(low)} : Enclosed{low, low, high};
  }
}

}  // namespace touchstone::oracle
