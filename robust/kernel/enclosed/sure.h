// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/enclosed/loose.h"

/// Enclosed numbers in which formulas of any degree can be written as they stand, and programs that ask for signs: what
/// is not certain ends the computation.
namespace touchstone::robust::kernel {

/// Thrown where a sign or a rounded number is not certain, or a number is beyond the range.
struct Unsure {};

/// Call while a ControlWord is in scope: rounding is to nearest, and underflow gradual.
///
/// Every number is 0, exactly; or exact and at least 2^-200 in size; or its bound is at least 2^-400; and none exceeds
/// 2^200. So nothing overflows. A head that is a product of two exact numbers is at least 2^-402, and a tenth of its
/// bound, E of it, is at least 2^-480. Where a factor is not exact, its bound times the other's size is at least
/// 2^-600, or times the other's bound 2^-800, a quarter of which the bound has to spare; so it is with quotients by a
/// settled number of at least 2^-200, and with roots of one. Underflow changes a result by less than 2^-1022, and by no
/// more than 2^200 times that where it is divided afterwards, which is less than 2^-820: all of this is less. A sum
/// that underflows is exact. Not proved by machine.
class Sure {
 public:
  Sure() = default;
  explicit Sure(double x) : Sure(Loose(x)) {}

  friend Sure operator+(const Sure& x, const Sure& y) { return Sure(x.value_ + y.value_); }
  friend Sure operator-(const Sure& x, const Sure& y) { return Sure(x.value_ - y.value_); }
  friend Sure operator-(const Sure& x) { return Sure(-x.value_); }
  friend Sure operator*(const Sure& x, const Sure& y) {
    if (x.is_one()) return y;
    return y.is_one() ? x : Sure(x.value_ * y.value_);
  }
  friend Sure operator/(const Sure& x, const Sure& y) {
    if (y.is_one()) return x;
    const Enclosed<double> below = y.in_order();
    if (!below.settled() || !(magnitude(below.high) >= 0x1p-200)) end();
    return Sure(Loose(x.in_order() / Divisor(below)));
  }
  friend Sure square_root(const Sure& x) {
    if (sign(x) == 0) return Sure();
    const Enclosed<double> square = x.in_order();
    if (!(square.high >= 0x1p-200)) end();
    return Sure(Loose(kernel::square_root(square)));
  }

  friend int sign(const Sure& x) {
    if (none_of(x.value_)) return 0;
    const Enclosed<double> value = x.in_order();
    if (!(value.settled() && magnitude(value.high) > 0)) end();
    return value.high > 0 ? 1 : -1;
  }
  /// Bounds of the number.
  friend double at_least(const Sure& x) { return x.middle() - x.reach(); }
  friend double at_most(const Sure& x) { return x.middle() + x.reach(); }
  friend double nearest(const Sure& x) {
    const auto number = rounded(x.in_order());
    if (!number) end();
    return *number;
  }

 private:
  static double magnitude(double x) { return filters::FloatFormat<double>::magnitude(x); }

  [[gnu::always_inline]] explicit Sure(const Loose& value) : value_(value) {
    const double high = magnitude(value.high), size = high + magnitude(value.low) + value.error;
    const bool large_enough = value.error >= 0x1p-400 || (value.error == 0 && (high >= 0x1p-200 || size == 0));
    if (!large_enough || !(size <= 0x1p200)) [[unlikely]]
      end();
  }
  [[noreturn, gnu::cold]] static void end() { throw Unsure(); }
  Enclosed<double> in_order() const {
    const Pair<double> parts = kernel::in_order(static_cast<const Enclosed<double>&>(value_));
    return {parts.high, parts.low, value_.error};
  }

  bool is_one() const { return value_.high == 1 && value_.low == 0 && value_.error == 0; }
  double middle() const { return value_.high + value_.low; }
  /// Twice the error, and four times what rounds in the middle, here, and in the sum of both.
  double reach() const { return 2 * value_.error + 0x1p-50 * (magnitude(value_.high) + magnitude(value_.low)); }

  Loose value_{0.0};
};

/// The names of one_root.h.
inline Sure with_root(const Sure& p, const Sure& q, const Sure& square) { return p + q * square_root(square); }
inline const Vector3<Sure>& with_root(const Vector3<Sure>& v) { return v; }
inline Sure of_53_digits(const Sure& x) { return Sure(nearest(x)); }

}  // namespace touchstone::robust::kernel
