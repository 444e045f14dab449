// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstring>

namespace touchstone::catalogue {

/// a * b + c, rounded once to nearest.
#if defined(__MINGW32__)
/// The std::fma of MinGW-w64 rounds a product to 64 bits, then a sum, and then to double. Here all is computed in 113
/// bits: the product is exact (106 bits; its exponent fits), and a sum that is not exact is rounded to odd, after which
/// rounding to 53 bits is right (Boldo and Melquiond, 2008).
inline double fused(double a, double b, double c) {
  __extension__ typedef __float128 Wide;
  __extension__ typedef unsigned __int128 Bits;
  const Wide product = Wide(a) * Wide(b), addend = c, sum = product + addend;
  const Wide of_addend = sum - product;  // two_sum: the error of the sum
  const Wide error = (product - (sum - of_addend)) + (addend - of_addend);
  Bits bits;
  std::memcpy(&bits, &sum, sizeof bits);
  if ((error < 0 || error > 0) && (bits & 1) == 0) bits += (error > 0) == (sum > 0) ? 1 : Bits(-1);
  Wide odd;
  std::memcpy(&odd, &bits, sizeof odd);
  return double(odd);
}
#else
inline double fused(double a, double b, double c) { return std::fma(a, b, c); }
#endif

}  // namespace touchstone::catalogue
