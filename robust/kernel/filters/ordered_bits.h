// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// Integers in the order of the doubles, with infinities at both ends and -0.0 equal to 0.0: read from the bits, so
/// that rounding mode and denormals-are-zero cannot affect it. Neighbours differ by 1; a NaN lies beyond the infinity
/// of its sign.
inline std::int64_t ordered_bits(double value) {
  const auto bits = std::bit_cast<std::int64_t>(value), sign = bits >> 63;
  return (bits ^ (sign & std::numeric_limits<std::int64_t>::max())) - sign;
}

}  // namespace touchstone::robust::kernel
