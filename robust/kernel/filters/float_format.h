// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::filters {

/// 2^exponent as a double, -1022 <= exponent <= 1023.
constexpr double power_of_two(int exponent) {
  return __builtin_bit_cast(double, static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// The properties of a binary floating-point format that filters need. A toy format specialises this for its own Float,
/// which needs the operators - + * < > >= <= and no conversion; at least 5 bits of precision, and an exponent range as
/// filters.h asserts.
///
///   precision     significant bits, the hidden one included
///   min_exponent  2^min_exponent is the smallest normal number
///   max_exponent  the largest number lies below 2^(max_exponent + 1)
///   above(c)      the least Float that is not below the real number c > 0, whatever the rounding mode
///   magnitude(x)  |x|, exact
///
/// robust/kernel/enclosed/enclosed.h needs no exponents, but also:
///
///   head(x)         x cut to precision / 2 digits
///   square_root(x)  rounded
template <class Float>
struct FloatFormat;

template <>
struct FloatFormat<double> {
  static constexpr int precision = 53, min_exponent = -1022, max_exponent = 1023;
  static constexpr double above(double c) { return c; }
  static double magnitude(double x) { return __builtin_fabs(x); }
  /// Stays in the floating-point register: g++ would move an integer through another one, which takes longer than a
  /// product.
  static double head(double x) {
    __extension__ typedef double Lanes __attribute__((vector_size(16)));
    __extension__ typedef long long Bits __attribute__((vector_size(16)));
    const Bits kept = reinterpret_cast<Bits>(Lanes{x, 0}) & ~((1LL << 27) - 1);
    return reinterpret_cast<Lanes>(kept)[0];
  }
  static double square_root(double x) { return __builtin_sqrt(x); }
};

}  // namespace touchstone::robust::filters
