// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

namespace touchstone::catalogue {

/// The number type in which a reference formula is run without rounding: a rational, or undefined. x / 0 is undefined,
/// and so is everything computed from it; every comparison with it is false, as with NaN.
class Exact {
 public:
  Exact() = default;
  Exact(int value) : value_(value) {}
  explicit Exact(mpq_class value) : value_(std::move(value)) {}

  bool defined() const { return defined_; }
  const mpq_class& value() const { return value_; }

  friend Exact operator+(const Exact& a, const Exact& b) { return Exact(mpq_class(a.value_ + b.value_), a, b); }
  friend Exact operator-(const Exact& a, const Exact& b) { return Exact(mpq_class(a.value_ - b.value_), a, b); }
  friend Exact operator*(const Exact& a, const Exact& b) { return Exact(mpq_class(a.value_ * b.value_), a, b); }
  friend Exact operator/(const Exact& a, const Exact& b) {
    if (sgn(b.value_) == 0) {
      Exact undefined;
      undefined.defined_ = false;
      return undefined;
    }
    return Exact(mpq_class(a.value_ / b.value_), a, b);
  }
  friend Exact operator-(const Exact& a) { return Exact(mpq_class(-a.value_), a, a); }

  friend bool operator<(const Exact& a, const Exact& b) { return both(a, b) && a.value_ < b.value_; }
  friend bool operator>(const Exact& a, const Exact& b) { return both(a, b) && a.value_ > b.value_; }
  friend bool operator<=(const Exact& a, const Exact& b) { return both(a, b) && a.value_ <= b.value_; }
  friend bool operator>=(const Exact& a, const Exact& b) { return both(a, b) && a.value_ >= b.value_; }
  friend bool operator==(const Exact& a, const Exact& b) { return both(a, b) && a.value_ == b.value_; }
  friend bool operator!=(const Exact& a, const Exact& b) { return !(a == b); }

  /// Irrational: rationals within 2^-2399 of the true value, relatively.
  friend Exact cos(const Exact& a);
  friend Exact sin(const Exact& a);
  /// The same; undefined outside [-1, 1].
  friend Exact acos(const Exact& a);
  /// Exact for squares, else within 2^-8999 relatively; undefined below 0.
  friend Exact sqrt(const Exact& a);

 private:
  Exact(mpq_class value, const Exact& a, const Exact& b) : value_(std::move(value)), defined_(both(a, b)) {}
  static bool both(const Exact& a, const Exact& b) { return a.defined_ && b.defined_; }

  mpq_class value_;
  bool defined_ = true;
};

}  // namespace touchstone::catalogue
