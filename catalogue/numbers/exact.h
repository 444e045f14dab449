// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

namespace touchstone::catalogue {

/// The number type for running a reference formula without rounding: a rational, or undefined. x / 0 is undefined, and
/// so is everything computed from it; every comparison with it is false, as with NaN.
class Exact {
 public:
  Exact() = default;
  Exact(int value) : digits_(value) {}
  explicit Exact(mpq_class value) { keep(std::move(value)); }

  bool defined() const { return defined_; }
  mpq_class value() const { return rational_ ? *rational_ : in_full(); }

  friend Exact operator+(const Exact& a, const Exact& b) {
    std::int64_t x = 0, y = 0, sum = 0;
    if (on_one_power(a, b, x, y) && !__builtin_add_overflow(x, y, &sum)) return Exact(sum, lesser_power(a, b));
    return Exact(mpq_class(a.value() + b.value()), a, b);
  }
  friend Exact operator-(const Exact& a, const Exact& b) {
    std::int64_t x = 0, y = 0, difference = 0;
    if (on_one_power(a, b, x, y) && !__builtin_sub_overflow(x, y, &difference))
      return Exact(difference, lesser_power(a, b));
    return Exact(mpq_class(a.value() - b.value()), a, b);
  }
  friend Exact operator*(const Exact& a, const Exact& b) {
    std::int64_t product = 0;
    if (a.short_and_defined() && b.short_and_defined() && !__builtin_mul_overflow(a.digits_, b.digits_, &product))
      return Exact(product, a.power_ + b.power_);
    return Exact(mpq_class(a.value() * b.value()), a, b);
  }
  friend Exact operator/(const Exact& a, const Exact& b) {
    if (b.sign() == 0) {
      Exact undefined;
      undefined.defined_ = false;
      return undefined;
    }
    return Exact(mpq_class(a.value() / b.value()), a, b);
  }
  friend Exact operator-(const Exact& a) { return Exact(0) - a; }

  friend bool operator<(const Exact& a, const Exact& b) { return both(a, b) && order(a, b) < 0; }
  friend bool operator>(const Exact& a, const Exact& b) { return both(a, b) && order(a, b) > 0; }
  friend bool operator<=(const Exact& a, const Exact& b) { return both(a, b) && order(a, b) <= 0; }
  friend bool operator>=(const Exact& a, const Exact& b) { return both(a, b) && order(a, b) >= 0; }
  friend bool operator==(const Exact& a, const Exact& b) { return both(a, b) && order(a, b) == 0; }
  friend bool operator!=(const Exact& a, const Exact& b) { return !(a == b); }

  /// Irrational: rationals within 2^-2399 of the true value, relatively.
  friend Exact cos(const Exact& a);
  friend Exact sin(const Exact& a);
  /// The same; undefined outside [-1, 1].
  friend Exact acos(const Exact& a);
  /// Exact for squares, otherwise within 2^-8999 relatively; undefined below 0.
  friend Exact sqrt(const Exact& a);

 private:
  Exact(std::int64_t digits, int power) : digits_(digits), power_(digits == 0 ? 0 : power) {}
  Exact(mpq_class value, const Exact& a, const Exact& b) : defined_(both(a, b)) { keep(std::move(value)); }
  static bool both(const Exact& a, const Exact& b) { return a.defined_ && b.defined_; }

  bool short_and_defined() const { return !rational_ && defined_; }
  int sign() const { return rational_ ? sgn(*rational_) : (digits_ > 0) - (digits_ < 0); }
  static int lesser_power(const Exact& a, const Exact& b) {
    return a.digits_ == 0 ? b.power_ : b.digits_ == 0 ? a.power_ : std::min(a.power_, b.power_);
  }
  /// Both as x and y times 2^lesser_power; false if that takes more digits.
  static bool on_one_power(const Exact& a, const Exact& b, std::int64_t& x, std::int64_t& y) {
    if (!a.short_and_defined() || !b.short_and_defined()) return false;
    const int power = lesser_power(a, b);
    const auto shifted = [power](const Exact& number, std::int64_t& found) {
      const int places = number.digits_ == 0 ? 0 : number.power_ - power;
      return places < 62 && !__builtin_mul_overflow(number.digits_, std::int64_t{1} << places, &found);
    };
    return shifted(a, x) && shifted(b, y);
  }
  static int order(const Exact& a, const Exact& b) {
    std::int64_t x = 0, y = 0;
    if (a.sign() != b.sign() || a.sign() == 0) return a.sign() - b.sign();
    if (on_one_power(a, b, x, y)) return (x > y) - (x < y);
    return cmp(a.value(), b.value());
  }
  mpq_class in_full() const;
  void keep(mpq_class value);

  std::int64_t digits_ = 0;  ///< times 2^power_: most numbers fit, and need no memory of their own
  int power_ = 0;
  bool defined_ = true;
  std::optional<mpq_class> rational_;  ///< for the others
};

}  // namespace touchstone::catalogue
