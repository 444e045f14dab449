// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace touchstone::catalogue {

/// A floating-point number that carries a bound of its own rounding error: running error analysis (Higham, Accuracy and
/// Stability of Numerical Algorithms, 2nd ed., section 3.3), made rigorous by rounding every bound up.
///
/// A reference formula run in this type computes the same as in double or in float, bit for bit, and at the end each
/// number lies within `error()` of the value of the same formula in exact arithmetic. An operation that happens to be
/// exact adds nothing. A comparison that the bound cannot decide sets `inconclusive()`: as long as it is not set,
/// rounding cannot have changed the course of the formula. A number that left the range of the format during the
/// computation, by overflow or by bits lost below the least normal number, sets `out_of_range()`. Rounding to nearest.
///
/// The format is chosen at run time. In binary32 every result is computed in double and rounded to float, which gives
/// the result of float: 53 digits are at least 2 * 24 + 2 (Figueroa, When is double rounding innocuous?, SIGNUM
/// Newsletter 30, 1995), and where float has fewer digits, sums are exact, and quotients of two floats are no nearer to
/// a midpoint of two floats than 2^-48 of their size.
class Tracked {
 public:
  Tracked() = default;
  Tracked(int value) : value_(rounded(value)) {}
  explicit Tracked(double value);  ///< rounded to the format, then exact

  /// Numbers of this thread are floats while one of these that was made with `true` lives, else doubles.
  class Format {
   public:
    explicit Format(bool binary32);
    ~Format();
    Format(const Format&) = delete;
    Format& operator=(const Format&) = delete;

   private:
    bool before_;
  };

  double value() const { return value_; }
  double error() const { return error_; }
  /// A bound on the rounding of formulas with about these steps: like error(), but to first order, and every given or
  /// computed number counts as rounded, even if it is exact. error() is 0 if this formula happens to be exact, while an
  /// equally good one may round there. Integers that the formula itself contains are exact.
  double spread() const { return spread_; }
  static bool& inconclusive();
  /// The least |a - b| of all comparisons so far, in units of the rounding of a and b (spread): below 1 the formula is
  /// as near to another course as its own rounding, at 0 two given or computed numbers are equal. It is not reset.
  static double& nearest_comparison();
  /// A finite sum, product or quotient became infinite, or a nonzero product or quotient lost bits because it is less
  /// than the least normal number. Sums lose none there. Undefined results do not count.
  static bool& out_of_range();

  friend Tracked operator+(const Tracked& a, const Tracked& b);
  friend Tracked operator-(const Tracked& a, const Tracked& b);
  friend Tracked operator-(const Tracked& a);
  friend Tracked operator*(const Tracked& a, const Tracked& b);
  friend Tracked operator/(const Tracked& a, const Tracked& b);

  friend bool operator<(const Tracked& a, const Tracked& b) { return settled(a, b), a.value_ < b.value_; }
  friend bool operator>(const Tracked& a, const Tracked& b) { return settled(a, b), a.value_ > b.value_; }
  friend bool operator<=(const Tracked& a, const Tracked& b) { return settled(a, b), a.value_ <= b.value_; }
  friend bool operator>=(const Tracked& a, const Tracked& b) { return settled(a, b), a.value_ >= b.value_; }
  friend bool operator==(const Tracked& a, const Tracked& b) { return settled(a, b), a.value_ == b.value_; }
  friend bool operator!=(const Tracked& a, const Tracked& b) { return settled(a, b), a.value_ != b.value_; }

  /// The C library's cosine and sine, assumed to be off by at most two units in the last place (glibc's manual: one).
  friend Tracked cos(const Tracked& a);
  friend Tracked sin(const Tracked& a);
  /// The root is rounded correctly; an error e of the argument a moves it by at most e / sqrt(a - e).
  friend Tracked sqrt(const Tracked& a);
  /// An error e of the argument a moves the arc cosine by at most e / sqrt(1 - (|a| + e)^2); near the ends by at most
  /// pi sqrt(e / 2), since 1 - cos x >= 2 x^2 / pi^2. Beyond 1 it is undefined, and whether the argument is beyond is a
  /// comparison.
  friend Tracked acos(const Tracked& a);

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  Tracked(double value, double error, double spread);
  static double rounded(double value);
  static Tracked undefined(double value);
  static Tracked library(double result, const Tracked& argument);
  static Tracked sum(const Tracked& a, const Tracked& b, double addend);
  static bool overflowed(const Tracked& a, const Tracked& b, double result);
  static void settled(const Tracked& a, const Tracked& b);

  double value_ = 0;
  double error_ = 0, spread_ = 0;
  bool undefined_ = false;
};

}  // namespace touchstone::catalogue
