// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/enclosed/enclosed.h"
#include "robust/kernel/enclosed/two.h"

/// The range of numbers for which enclosed.h is valid.
namespace touchstone::robust::kernel {

/// Returns whether the processor rounds to nearest, i.e. to 1 for both: in any other mode the sum is above 1 or the
/// difference below. The numbers are normal, so that FTZ and DAZ have no effect.
inline bool rounds_to_nearest() {
  const double tiny = processor::at_run_time(0x1p-60);
  return 1 + tiny <= 1 - tiny;
}

/// Checks that numbers are 0, or of a magnitude in [2^-100, 2^100]: finite.
///
/// Then all are multiples of 2^-152. Sums and products of multiples of such a unit are multiples of its power, also
/// rounded, and a head is one where its number is. So polynomials of degree d in these numbers come out, with all their
/// tails, as multiples of 2^(-152 d) below 2^(100 d + 12); up to d = 4 nothing underflows or overflows, and FTZ and DAZ
/// flush nothing. A quotient of two of degree 2 is 0 or lies between 2^-517 and 2^517, its head is a multiple of
/// 2^-543, and what is left, n - q d, is a multiple of 2^(-543 - 304). Only that times the inverse may underflow: by
/// less than 2^-1022, of which E 2^-517, that the bound has to spare, holds plenty. A root of degree 4 lies between
/// 2^-304 and 2^206, and what is left of it is a multiple of 2^-660.
class Window {
 public:
  explicit Window(Two first) : small_(small(first)), sizes_(magnitude(first)) {}

  Window& add(Two x) {
    small_ |= small(x);
    sizes_ = sizes_ + magnitude(x);
    return *this;
  }
  /// For a list, 2^100 bounds the sum of magnitudes.
  bool holds() const { return none_small() && sizes_ <= Two(0x1p100); }
  /// The lower bound alone; also holds for NaN.
  bool none_small() const { return (small_[0] | small_[1]) == 0; }

 private:
  static Two magnitude(Two x) { return filters::FloatFormat<Two>::magnitude(x); }
  /// Sets the bits of numbers that are below 2^-100 and not 0. A comparison may read a subnormal as zero, which is
  /// small too, so the bits decide whether it is zero.
  static Two::Bits small(Two x) {
    const Two::Lanes size = magnitude(x).lanes;
    return (size < Two(0x1p-100).lanes) & reinterpret_cast<Two::Bits>(size);
  }

  Two::Bits small_;
  Two sizes_;
};

template <class... Numbers>
bool in_window(Two first, Numbers... others) {
  Window window(first);
  (window.add(others), ...);
  return window.holds();
}

/// Checks the lower bound alone, if overflow shows in the answer. It excludes underflow: it makes all numbers multiples
/// of 2^-152.
template <class... Numbers>
bool none_small(Two first, Numbers... others) {
  Window window(first);
  (window.add(others), ...);
  return window.none_small();
}

}  // namespace touchstone::robust::kernel
