// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>

#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// A finite double as (negative ? -1 : 1) * magnitude * 2^exponent, read from its bits without floating-point
/// operations, so that rounding mode and denormals-are-zero cannot affect it.
struct Decoded {
  std::uint64_t magnitude;
  int exponent;
  bool negative;
};

inline Decoded decode(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const int field = static_cast<int>(bits >> 52 & 0x7ff);
  const std::uint64_t fraction = bits & 0xfffffffffffffu;
  const std::uint64_t hidden = static_cast<std::uint64_t>(field != 0) << 52;
  return {fraction | hidden, field + (field == 0) - 1075, bits >> 63 != 0};
}

/// Returns the sign bit, which is set for -0.0, too. With -fno-signed-zeros a compiler turns std::signbit into "less
/// than 0", and denormals-are-zero then takes a negative subnormal for 0.
inline bool sign_bit(double value) { return std::bit_cast<std::int64_t>(value) < 0; }

}  // namespace touchstone::robust::kernel
