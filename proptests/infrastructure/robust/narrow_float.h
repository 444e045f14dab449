// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "robust/kernel/filters/float_format.h"

namespace touchstone::proptests {

/// A format of few digits and a double's exponents, rounded to nearest: what robust/kernel/enclosed/enclosed.h rests
/// on. The sum, product, quotient and root of two such numbers, rounded to double and then to p digits, is rounded
/// once, as 53 >= 2 p + 2 (Figueroa 1995).
template <int p>
class Narrow {
 public:
  static_assert(2 * p + 2 <= 53);

  Narrow() = default;
  /// Rounded.
  explicit Narrow(double x) : value_(rounded(x)) {}
  double value() const { return value_; }

  static double rounded(double x) {
    return cut_to(p, x, [](double count) { return std::nearbyint(count); });
  }
  /// cut(x / unit) * unit for the unit of a number of so many digits.
  template <class Cut>
  static double cut_to(int digits, double x, const Cut& cut) {
    if (x == 0) return x;
    const double unit = std::ldexp(1.0, std::ilogb(x) + 1 - digits);
    return cut(x / unit) * unit;
  }

  friend Narrow operator+(Narrow a, Narrow b) { return Narrow(a.value_ + b.value_); }
  friend Narrow operator-(Narrow a, Narrow b) { return Narrow(a.value_ - b.value_); }
  friend Narrow operator*(Narrow a, Narrow b) { return Narrow(a.value_ * b.value_); }
  friend Narrow operator/(Narrow a, Narrow b) { return Narrow(a.value_ / b.value_); }
  friend Narrow operator-(Narrow a) { return Narrow(-a.value_); }
  friend bool operator>=(Narrow a, Narrow b) { return a.value_ >= b.value_; }
  friend bool operator<=(Narrow a, Narrow b) { return a.value_ <= b.value_; }

 private:
  double value_ = 0;
};

}  // namespace touchstone::proptests

namespace touchstone::robust::filters {

template <int p>
struct FloatFormat<proptests::Narrow<p>> {
  using Float = proptests::Narrow<p>;
  static constexpr int precision = p;
  static Float above(double c) {
    return Float(Float::cut_to(p, c, [](double count) { return std::ceil(count); }));
  }
  static Float magnitude(Float x) { return Float(std::fabs(x.value())); }
  static Float head(Float x) {
    return Float(Float::cut_to(p / 2, x.value(), [](double count) { return std::trunc(count); }));
  }
  static Float square_root(Float x) { return Float(std::sqrt(x.value())); }
};

}  // namespace touchstone::robust::filters
