// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "arithmetic/integer.h"

namespace touchstone::arithmetic {
inline namespace TOUCHSTONE_WORDS {

/// Newton's iteration a <- (a + n / a) / 2 on the leading digits of n, twice as many each time: a step is one division.
/// Each a is within 1 of the root of the digits that it has seen (R. Brent and P. Zimmermann, Modern Computer
/// Arithmetic, 1.5.1).
Integer sqrt(const Integer& n) {
  if (n.is_zero()) return n;
  const std::uint64_t half = (n.bit_length() - 1) / 2;  // bits of the root below its highest
  Integer a(1);
  std::uint64_t done = 0;
  for (int s = static_cast<int>(std::bit_width(half)) - 1; s >= 0; --s) {
    const std::uint64_t before = done;
    done = half >> s;
    Integer top(n);
    top.cut(2 * half - before - done + 1);
    top /= a;
    a <<= done - before - 1;
    a += top;
  }
  if (a * a > n) --a;
  return a;
}

/// Newton's iteration from above: it falls until it is the root.
Integer root(const Integer& n, std::uint64_t degree) {
  if (n.is_zero() || degree == 1) return n;
  if (degree == 2) return sqrt(n);
  Integer a = Integer(1) << (n.bit_length() / degree + 1);
  for (;;) {
    Integer next = (a * Integer(degree - 1) + n / power(a, degree - 1)) / Integer(degree);
    if (next >= a) return a;
    a = std::move(next);
  }
}

bool is_square(const Integer& n) {
  if (n.sign() < 0) return false;
  constexpr std::uint64_t squares_modulo_64 = 0x202021202030213u;
  if ((squares_modulo_64 >> (n.bits64() & 63) & 1) == 0) return false;
  const Integer a = sqrt(n);
  return a * a == n;
}

}  // namespace TOUCHSTONE_WORDS
}  // namespace touchstone::arithmetic
