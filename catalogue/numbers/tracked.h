// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace touchstone::catalogue {

/// A floating-point number that carries a bound of its own rounding error: running error analysis (Higham, Accuracy and
/// Stability of Numerical Algorithms, 2nd ed., section 3.3), made rigorous by rounding every bound up.
///
/// A reference formula run in this type computes the same as in Float, bit for bit, and at the end each number
/// lies within `error()` of the value of the same formula in exact arithmetic. An operation that happens to be exact
/// adds nothing. A comparison that the bound cannot decide sets `inconclusive()`: as long as it is not set, rounding
/// cannot have changed the course of the formula. A number that left the range of Float during the computation, by
/// overflow or by bits lost below the least normal number, sets `out_of_range()`. Float: float or double, rounding to
/// nearest.
template <class Float>
class Tracked {
 public:
  Tracked() = default;
  Tracked(int value) : value_(static_cast<Float>(value)) {}
  explicit Tracked(Float value)  // exact
      : value_(value), spread_(finite_or_infinite(value, unit * magnitude(value))) {}

  Float value() const { return value_; }
  double error() const { return error_; }
  /// A bound on the rounding of formulas with about these steps: like error(), but to first order, and every given or
  /// computed number counts as rounded, even if it is exact. error() is 0 if this formula happens to be exact, while an
  /// equally good one may round there. Integers that the formula itself contains are exact.
  double spread() const { return spread_; }
  static bool& inconclusive() {
    thread_local bool doubt = false;
    return doubt;
  }
  /// The least |a - b| of all comparisons so far, in units of the rounding of a and b (spread): below 1 the formula is
  /// as near to another course as its own rounding, at 0 two given or computed numbers are equal. It is not reset.
  static double& nearest_comparison() {
    thread_local double nearest = infinite;
    return nearest;
  }
  /// A finite sum, product or quotient became infinite, or a nonzero product or quotient lost bits because it is less
  /// than the least normal number. Sums lose none there. Undefined results do not count.
  static bool& out_of_range() {
    thread_local bool left = false;
    return left;
  }

  friend Tracked operator+(const Tracked& a, const Tracked& b) {
    return kept_undefined(a, b, sum(a, b, a.value_ + b.value_, b.value_));
  }
  friend Tracked operator-(const Tracked& a, const Tracked& b) {
    return kept_undefined(a, b, sum(a, b, a.value_ - b.value_, -b.value_));
  }
  friend Tracked operator-(const Tracked& a) {
    return a.undefined_ ? undefined(-a.value_) : Tracked(-a.value_, a.error_, a.spread_);
  }

  friend Tracked operator*(const Tracked& a, const Tracked& b) {
    const Float product = a.value_ * b.value_;
    if (a.undefined_ || b.undefined_) return undefined(product);
    if (overflowed(a, b, product) || product_underflowed(a.value_, b.value_, product)) out_of_range() = true;
    const double propagated = plus(times(size(a), b.error_), times(plus(size(b), b.error_), a.error_));
    return Tracked(product, plus(propagated, product_rounding(a.value_, b.value_, product)),
                   size(a) * b.spread_ + (size(b) + b.spread_) * a.spread_ + step(product));
  }

  friend Tracked operator/(const Tracked& a, const Tracked& b) {
    const Float quotient = a.value_ / b.value_;
    if (a.undefined_ || b.undefined_) return undefined(quotient);
    if (a.error_ == 0 && b.value_ == 0 && b.error_ == 0) return undefined(quotient);
    if (b.value_ != 0 && (overflowed(a, b, quotient) || quotient_underflowed(a.value_, b.value_, quotient)))
      out_of_range() = true;
    const double least_divisor = down(size(b) - b.error_);
    const double least = size(b) - b.spread_;
    const double spread = least > 0 ? (a.spread_ + magnitude(quotient) * b.spread_) / least + step(quotient) : infinite;
    if (!(least_divisor > 0) || !std::isfinite(quotient)) return Tracked(quotient, infinite, spread);
    const double propagated = over(plus(a.error_, times(magnitude(quotient), b.error_)), least_divisor);
    const bool exact = std::fma(quotient, b.value_, -a.value_) == 0 && magnitude(a.value_) > safe_product;
    const double rounding = exact || a.value_ == 0 ? 0 : half_ulp(quotient);
    // The propagated term is relative to the computed quotient; its own rounding enters once more through the divisor.
    return Tracked(quotient, plus(propagated, times(rounding, over(size(b), least_divisor))), spread);
  }

  friend bool operator<(const Tracked& a, const Tracked& b) { return settled(a, b), a.value_ < b.value_; }
  friend bool operator>(const Tracked& a, const Tracked& b) { return settled(a, b), a.value_ > b.value_; }
  friend bool operator<=(const Tracked& a, const Tracked& b) { return settled(a, b), a.value_ <= b.value_; }
  friend bool operator>=(const Tracked& a, const Tracked& b) { return settled(a, b), a.value_ >= b.value_; }
  friend bool operator==(const Tracked& a, const Tracked& b) { return settled(a, b), a.value_ == b.value_; }
  friend bool operator!=(const Tracked& a, const Tracked& b) { return settled(a, b), a.value_ != b.value_; }

  /// The C library's cosine and sine, assumed to be off by at most two units in the last place (glibc's manual: one).
  friend Tracked cos(const Tracked& a) { return library(std::cos(a.value_), a); }
  friend Tracked sin(const Tracked& a) { return library(std::sin(a.value_), a); }

  /// The root is rounded correctly; an error e of the argument a moves it by at most e / sqrt(a - e).
  friend Tracked sqrt(const Tracked& a) {
    const Float root = std::sqrt(a.value_);
    if (a.undefined_) return undefined(root);
    const bool exact = std::fma(root, root, -a.value_) == 0 && (magnitude(a.value_) > safe_product || a.value_ == 0);
    if (!(a.value_ >= 0)) return Tracked(root, infinite, infinite);
    const double nearer = size(a) - a.spread_;
    const double spread =
        (nearer > 0 ? a.spread_ / (magnitude(root) + std::sqrt(nearer)) : std::sqrt(size(a) + a.spread_)) + step(root);
    if (exact && a.error_ == 0) return Tracked(root, 0, spread);
    const double least = down(size(a) - a.error_);
    // Below the error the root is anything from 0 to sqrt(a + e).
    const double propagated = least > 0 ? over(a.error_, down(std::sqrt(least)))
                                        : std::nextafter(std::sqrt(plus(size(a), a.error_)), infinite);
    return Tracked(root, plus(propagated, half_ulp(root)), spread);
  }

  /// An error e of the argument a moves the arc cosine by at most e / sqrt(1 - (|a| + e)^2); near the ends by at most
  /// pi sqrt(e / 2), since 1 - cos x >= 2 x^2 / pi^2. Beyond 1 it is undefined, and whether the argument is beyond is a
  /// comparison.
  friend Tracked acos(const Tracked& a) {
    if (a.undefined_) return undefined(std::acos(a.value_));
    const double most = plus(size(a), a.error_);
    if (most > 1 && a.error_ > 0) inconclusive() = true;
    const Float angle = std::acos(a.value_);
    const double spread = moved_angle(size(a), a.spread_) + 4 * step(angle);
    if (a.error_ == 0) return Tracked(angle, a.value_ == 1 ? 0 : 4 * half_ulp(angle), spread);
    return Tracked(angle, plus(moved_angle(size(a), a.error_), 4 * half_ulp(angle)), spread);
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  /// Products above this are far enough from the subnormals that their error term is a Float.
  static constexpr double safe_product = sizeof(Float) == 8 ? 0x1p-900 : 0x1p-100;

  Tracked(Float value, double error, double spread)
      : value_(value), error_(finite_or_infinite(value, error)), spread_(finite_or_infinite(value, spread)) {}

  /// A value that is not finite may be anything.
  static double finite_or_infinite(Float value, double bound) {
    return std::isfinite(value) && bound == bound ? bound : infinite;
  }

  /// x / 0 without any rounding before it, and everything computed from it: undefined in exact arithmetic too, so no
  /// comparison with it is uncertain. The value is that of Float, a NaN or an infinity at first.
  static Tracked undefined(Float value) {
    Tracked result(value, infinite, infinite);
    result.undefined_ = true;
    return result;
  }
  static Tracked kept_undefined(const Tracked& a, const Tracked& b, const Tracked& result) {
    if (a.undefined_ || b.undefined_) return undefined(result.value_);
    if (overflowed(a, b, result.value_)) out_of_range() = true;
    return result;
  }

  static bool overflowed(const Tracked& a, const Tracked& b, Float result) {
    return !std::isfinite(result) && std::isfinite(a.value_) && std::isfinite(b.value_);
  }
  static bool below_normal(Float x) { return std::fabs(x) < std::numeric_limits<Float>::min(); }
  /// The exponent of the last set bit of a finite nonzero number.
  static int last_bit(Float x) {
    int exponent = 0;
    const double digits = std::ldexp(std::frexp(magnitude(x), &exponent), 53);
    return exponent - 53 + std::countr_zero(static_cast<std::uint64_t>(digits));
  }
  static bool product_underflowed(Float a, Float b, Float product) {
    if (a == 0 || b == 0 || !below_normal(product)) return false;
    return last_bit(a) + last_bit(b) < last_bit(std::numeric_limits<Float>::denorm_min());
  }
  static bool quotient_underflowed(Float a, Float b, Float quotient) {
    if (a == 0 || !below_normal(quotient) || !std::isfinite(b)) return false;
    if (quotient == 0) return true;
    int exponent = 0;  // scaled so that the remainder of the division is a double: quotient * b - a
    const double divisor = std::frexp(static_cast<double>(b), &exponent);
    return std::fma(std::ldexp(static_cast<double>(quotient), 500), divisor,
                    -std::ldexp(static_cast<double>(a), 500 - exponent)) != 0;
  }

  static double magnitude(Float x) { return std::fabs(static_cast<double>(x)); }
  static double size(const Tracked& a) { return magnitude(a.value_); }
  // Bounds are added, multiplied and divided upwards: one step beyond the nearest double, unless the result is exactly
  // 0.
  static double plus(double x, double y) { return x == 0 ? y : y == 0 ? x : up(x + y); }
  static double times(double x, double y) { return x == 0 || y == 0 ? 0 : up(x * y); }
  static double over(double x, double y) { return x == 0 ? 0 : up(x / y); }
  /// The next double above a nonnegative one, from the bits: std::nextafter costs more than the rest of a product.
  static double up(double x) { return x < infinite ? std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + 1) : x; }
  static double down(double x) { return std::nextafter(x, -infinite); }
  static constexpr double unit = std::numeric_limits<Float>::epsilon() / 2;
  /// The contribution of one rounding to the spread of its result; below the normal numbers the least one.
  static double step(Float result) {
    return std::fmax(unit * magnitude(result), static_cast<double>(std::numeric_limits<Float>::denorm_min()));
  }
  static double half_ulp(Float x) {
    const Float next = std::nextafter(std::fabs(x), std::numeric_limits<Float>::infinity());
    const double gap = static_cast<double>(next) - magnitude(x);
    return gap == static_cast<double>(std::numeric_limits<Float>::denorm_min()) ? gap : gap / 2;
  }

  static Tracked sum(const Tracked& a, const Tracked& b, Float result, Float addend) {
    // A sum in the subnormal range is exact; otherwise TwoSum's error term is used (Knuth).
    const Float virtual_b = result - a.value_;
    const Float rest = (a.value_ - (result - virtual_b)) + (addend - virtual_b);
    const double rounding = rest == 0 ? 0 : half_ulp(result);
    return Tracked(result, plus(plus(a.error_, b.error_), rounding), a.spread_ + b.spread_ + step(result));
  }

  static double product_rounding(Float a, Float b, Float product) {
    if (a == 0 || b == 0) return 0;
    if (magnitude(product) > safe_product && std::fma(a, b, -product) == 0) return 0;
    return half_ulp(product);
  }

  /// The greatest change of the arc cosine for an error of an argument of that size; `moved` is 0 or more.
  static double moved_angle(double size, double moved) {
    const double most = plus(size, moved), room = down(1 - most);
    const double steep = room > 0 ? over(moved, down(std::sqrt(down(room * down(1 + most))))) : infinite;
    const double ends = times(0x1.921fb54442d19p+1, std::nextafter(std::sqrt(moved / 2), infinite));
    return std::fmin(steep, ends);
  }

  static Tracked library(Float result, const Tracked& argument) {
    if (argument.undefined_) return undefined(result);
    const bool exact = argument.value_ == 0 && argument.error_ == 0;
    return Tracked(result, exact ? 0 : plus(argument.error_, 4 * half_ulp(result)),
                   argument.spread_ + 4 * step(result));
  }

  static void settled(const Tracked& a, const Tracked& b) {
    if (a.undefined_ || b.undefined_) return;
    const double gap = std::fabs(static_cast<double>(a.value_) - static_cast<double>(b.value_));
    const double error = plus(a.error_, b.error_);
    if (error > 0 && !(down(gap) > error)) inconclusive() = true;
    const double spread = a.spread_ + b.spread_;
    if (gap < nearest_comparison() * spread) nearest_comparison() = gap / spread;
    if (a.value_ != a.value_ || b.value_ != b.value_) inconclusive() = true;
  }

  Float value_ = 0;
  double error_ = 0, spread_ = 0;
  bool undefined_ = false;
};

}  // namespace touchstone::catalogue
