// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>

#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// Scales numbers that are too large for a filter by 2^-700: the greatest is then below the guards of filters.h, 2^341.
/// A power of two changes no digit unless the product is subnormal. In that case, and if operands or results are
/// flushed to zero, scaling back does not restore the number, and `exact` is false. (Compared as bits: a subnormal that
/// is read as zero would equal zero.) Infinities and NaN do not change.
class Lessened {
 public:
  double operator()(double x) {
    const double less = x * 0x1p-700, back = less * 0x1p700;
    exact_ = exact_ && std::bit_cast<std::uint64_t>(back) == std::bit_cast<std::uint64_t>(x);
    return less;
  }
  bool exact() const { return exact_; }

 private:
  bool exact_ = true;
};

}  // namespace touchstone::robust::kernel
