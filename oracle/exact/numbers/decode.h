// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>

#include "geometry/int128.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

using Integer = mpz_class;

/// mantissa * 2^exponent, |mantissa| < 2^53.
struct Dyadic {
  std::int64_t mantissa;
  int exponent;
};

/// A finite double decomposed into bits. No floating-point operation is applied to it, so neither flush-to-zero,
/// denormals-are-zero nor a rounding mode can change its value. -0.0 is 0.
constexpr Dyadic decode(double value) {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(value);
  const int field = static_cast<int>(bits >> 52 & 0x7ff);
  const auto fraction = static_cast<std::int64_t>(bits & 0xfffffffffffff);
  const std::int64_t magnitude = field == 0 ? fraction : fraction | std::int64_t{1} << 52;
  return {bits >> 63 ? -magnitude : magnitude, (field == 0 ? 1 : field) - 1075};
}

/// The exponent that `decode` gives to infinities and NaNs, and to no finite double.
constexpr int decode_infinite = 0x7ff - 1075;

/// value * 2^exponent, canonical.
Rational scaled(Rational value, int exponent);
Rational scaled(const Integer& integer, int exponent);

/// The real value of a finite double.
Rational exact(double value);
inline const Rational& exact(const Rational& value) { return value; }

}  // namespace touchstone::oracle
