// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include "robust/kernel/strict_math.h"

namespace touchstone::robust::kernel {

/// Integers in the order of the doubles, infinities at both ends: neighbours differ by 1, both zeros are 0. Read from
/// the bits, so that denormals-are-zero cannot make two numbers equal. Not for NaN.
using OrderKey = std::int64_t;

inline OrderKey order_key(double x) {
  const auto bits = std::bit_cast<std::int64_t>(x);
  return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
}

}  // namespace touchstone::robust::kernel
