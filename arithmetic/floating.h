// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "arithmetic/rational.h"

namespace touchstone::arithmetic {
inline namespace TOUCHSTONE_WORDS {

/// digits 2^exponent, with a precision of so many bits, and 64 more: every result is cut towards 0. For guesses and for
/// texts, as GMP's mpf, which keeps a number of digits that depends on its words, too.
class Floating {
 public:
  Floating() = default;
  template <std::integral T>
  Floating(T x, std::int64_t precision = 64) : digits_(x), precision_(precision) {}
  Floating(const Rational& x, std::int64_t precision) : precision_(precision) { *this = x; }
  Floating(const Floating& x, std::int64_t precision)
      : digits_(x.digits_), exponent_(x.exponent_), precision_(precision) {
    cut();
  }
  /// Keeps its precision.
  Floating& operator=(const Rational& x);

  const Integer& digits() const { return digits_; }
  std::int64_t exponent() const { return exponent_; }
  void scale(std::int64_t exponent) { exponent_ += digits_.is_zero() ? 0 : exponent; }
  Floating* get_mpf_t() { return this; }
  const Floating* get_mpf_t() const { return this; }
  /// At most `most` digits, rounded to nearest, without zeros at the end, and the place of the point before them.
  std::string get_str(std::int64_t& point, int base, std::size_t most) const;

  friend Floating operator+(const Floating& a, const Floating& b) { return sum(a, b, false); }
  friend Floating operator-(const Floating& a, const Floating& b) { return sum(a, b, true); }
  friend Floating operator-(Floating a) {
    a.digits_.negate();
    return a;
  }
  friend Floating operator*(const Floating& a, const Floating& b) {
    return {a.digits_ * b.digits_, a.exponent_ + b.exponent_, std::max(a.precision_, b.precision_)};
  }
  friend Floating operator/(const Floating& a, const Floating& b);
  friend Floating sqrt(const Floating& a);
  friend Floating abs(Floating a) {
    a.digits_.set_negative(false);
    return a;
  }
  friend int sgn(const Floating& a) { return a.digits_.sign(); }
  friend bool operator==(const Floating& a, const Floating& b) { return exact_difference(a, b).is_zero(); }
  friend std::strong_ordering operator<=>(const Floating& a, const Floating& b) {
    return exact_difference(a, b).sign() <=> 0;
  }

 private:
  Floating(Integer digits, std::int64_t exponent, std::int64_t precision)
      : digits_(std::move(digits)), exponent_(exponent), precision_(precision) {
    cut();
  }
  void cut();
  static Floating sum(const Floating& a, const Floating& b, bool minus);
  static Integer exact_difference(const Floating& a, const Floating& b);

  Integer digits_;
  std::int64_t exponent_ = 0, precision_ = 64;
};

/// Written by C's format %g with so many digits.
std::string general_text(const Floating& x, int digits);

}  // namespace TOUCHSTONE_WORDS
}  // namespace touchstone::arithmetic
