// SPDX-License-Identifier: Apache-2.0
#include "catalogue/numbers/tracked.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include "catalogue/numbers/fused.h"

namespace touchstone::catalogue {
namespace {

/// The numbers that a format consists of. Products above `safe_product` are far enough from the subnormals that their
/// error term is a number of the format.
struct Limits {
  bool binary32;
  double unit, least_normal, least, safe_product;
};
constexpr Limits of_double{false, 0x1p-53, 0x1p-1022, 0x1p-1074, 0x1p-900},
    of_float{true, 0x1p-24, 0x1p-126, 0x1p-149, 0x1p-100};

const Limits*& chosen() {
  thread_local const Limits* limits = &of_double;
  return limits;
}
const Limits& format() { return *chosen(); }

/// A function of the C library in the format.
template <class Function>
double in_format(const Function& function, double x) {
  return format().binary32 ? static_cast<double>(function(static_cast<float>(x))) : function(x);
}

// Bounds are added, multiplied and divided upwards: one step beyond the nearest double, unless the result is exactly 0.

/// The next double above a nonnegative one, from the bits: std::nextafter costs more than the rest of a product.
double up(double x) {
  return x < std::numeric_limits<double>::infinity() ? std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + 1) : x;
}
double down(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }
double plus(double x, double y) { return x == 0 ? y : y == 0 ? x : up(x + y); }
double times(double x, double y) { return x == 0 || y == 0 ? 0 : up(x * y); }
double over(double x, double y) { return x == 0 ? 0 : up(x / y); }

/// The contribution of one rounding to the spread of its result; below the normal numbers the least one.
double step(double result) { return std::fmax(format().unit * std::fabs(result), format().least); }
double half_ulp(double x) {
  const double size = std::fabs(x), next = format().binary32 ? std::nextafter(static_cast<float>(size), HUGE_VALF)
                                                             : std::nextafter(size, HUGE_VAL);
  const double gap = next - size;
  return gap == format().least ? gap : gap / 2;
}

/// A value that is not finite may be anything.
double finite_or_infinite(double value, double bound) {
  return std::isfinite(value) && bound == bound ? bound : std::numeric_limits<double>::infinity();
}

bool below_normal(double x) { return std::fabs(x) < format().least_normal; }
/// The exponent of the last set bit of a finite nonzero number.
int last_bit(double x) {
  int exponent = 0;
  const double digits = std::ldexp(std::frexp(std::fabs(x), &exponent), 53);
  return exponent - 53 + std::countr_zero(static_cast<std::uint64_t>(digits));
}
bool product_underflowed(double a, double b, double product) {
  if (a == 0 || b == 0 || !below_normal(product)) return false;
  return last_bit(a) + last_bit(b) < last_bit(format().least);
}
bool quotient_underflowed(double a, double b, double quotient) {
  if (a == 0 || !below_normal(quotient) || !std::isfinite(b)) return false;
  if (quotient == 0) return true;
  int exponent = 0;  // scaled so that the remainder of the division is a double: quotient * b - a
  const double divisor = std::frexp(b, &exponent);
  return fused(std::ldexp(quotient, 500), divisor, -std::ldexp(a, 500 - exponent)) != 0;
}
double product_rounding(double a, double b, double product) {
  if (a == 0 || b == 0) return 0;
  if (std::fabs(product) > format().safe_product && fused(a, b, -product) == 0) return 0;
  return half_ulp(product);
}

/// The greatest change of the arc cosine for an error of an argument of that size; `moved` is 0 or more.
double moved_angle(double size, double moved) {
  const double most = plus(size, moved), room = down(1 - most);
  const double steep = room > 0 ? over(moved, down(std::sqrt(down(room * down(1 + most))))) : HUGE_VAL;
  const double ends = times(0x1.921fb54442d19p+1, std::nextafter(std::sqrt(moved / 2), HUGE_VAL));
  return std::fmin(steep, ends);
}

double size(const Tracked& a) { return std::fabs(a.value()); }

}  // namespace

Tracked::Format::Format(bool binary32) : before_(format().binary32) { chosen() = binary32 ? &of_float : &of_double; }
Tracked::Format::~Format() { chosen() = before_ ? &of_float : &of_double; }

Tracked::Tracked(double value)
    : value_(rounded(value)), spread_(finite_or_infinite(value_, format().unit * std::fabs(value_))) {}
Tracked::Tracked(double value, double error, double spread)
    : value_(value), error_(finite_or_infinite(value, error)), spread_(finite_or_infinite(value, spread)) {}

bool& Tracked::inconclusive() {
  thread_local bool doubt = false;
  return doubt;
}
double& Tracked::nearest_comparison() {
  thread_local double nearest = infinite;
  return nearest;
}
bool& Tracked::out_of_range() {
  thread_local bool left = false;
  return left;
}

double Tracked::rounded(double value) {
  return format().binary32 ? static_cast<double>(static_cast<float>(value)) : value;
}

/// x / 0 without any rounding before it, and everything computed from it: undefined in exact arithmetic too, so no
/// comparison with it is uncertain. The value is that of the format, a NaN or an infinity at first.
Tracked Tracked::undefined(double value) {
  Tracked result(value, infinite, infinite);
  result.undefined_ = true;
  return result;
}

bool Tracked::overflowed(const Tracked& a, const Tracked& b, double result) {
  return !std::isfinite(result) && std::isfinite(a.value_) && std::isfinite(b.value_);
}

Tracked Tracked::sum(const Tracked& a, const Tracked& b, double addend) {
  const double in_double = a.value_ + addend, result = rounded(in_double);
  if (a.undefined_ || b.undefined_) return undefined(result);
  if (overflowed(a, b, result)) out_of_range() = true;
  // TwoSum's error term (Knuth). A sum in the subnormal range is exact.
  const double virtual_b = in_double - a.value_;
  const double rest = (a.value_ - (in_double - virtual_b)) + (addend - virtual_b);
  const double rounding = rest == 0 && result == in_double ? 0 : half_ulp(result);
  return {result, plus(plus(a.error_, b.error_), rounding), a.spread_ + b.spread_ + step(result)};
}
Tracked operator+(const Tracked& a, const Tracked& b) { return Tracked::sum(a, b, b.value_); }
Tracked operator-(const Tracked& a, const Tracked& b) { return Tracked::sum(a, b, -b.value_); }
Tracked operator-(const Tracked& a) {
  return a.undefined_ ? Tracked::undefined(-a.value_) : Tracked(-a.value_, a.error_, a.spread_);
}

Tracked operator*(const Tracked& a, const Tracked& b) {
  const double product = Tracked::rounded(a.value_ * b.value_);
  if (a.undefined_ || b.undefined_) return Tracked::undefined(product);
  if (Tracked::overflowed(a, b, product) || product_underflowed(a.value_, b.value_, product))
    Tracked::out_of_range() = true;
  const double propagated = plus(times(size(a), b.error_), times(plus(size(b), b.error_), a.error_));
  return {product, plus(propagated, product_rounding(a.value_, b.value_, product)),
          size(a) * b.spread_ + (size(b) + b.spread_) * a.spread_ + step(product)};
}

Tracked operator/(const Tracked& a, const Tracked& b) {
  const double quotient = Tracked::rounded(a.value_ / b.value_);
  if (a.undefined_ || b.undefined_) return Tracked::undefined(quotient);
  if (a.error_ == 0 && b.value_ == 0 && b.error_ == 0) return Tracked::undefined(quotient);
  if (b.value_ != 0 && (Tracked::overflowed(a, b, quotient) || quotient_underflowed(a.value_, b.value_, quotient)))
    Tracked::out_of_range() = true;
  const double least_divisor = down(size(b) - b.error_), least = size(b) - b.spread_;
  const double spread =
      least > 0 ? (a.spread_ + std::fabs(quotient) * b.spread_) / least + step(quotient) : Tracked::infinite;
  if (!(least_divisor > 0) || !std::isfinite(quotient)) return {quotient, Tracked::infinite, spread};
  const double propagated = over(plus(a.error_, times(std::fabs(quotient), b.error_)), least_divisor);
  const bool exact = fused(quotient, b.value_, -a.value_) == 0 && size(a) > format().safe_product;
  const double rounding = exact || a.value_ == 0 ? 0 : half_ulp(quotient);
  // The propagated term is relative to the computed quotient; its own rounding enters once more through the divisor.
  return {quotient, plus(propagated, times(rounding, over(size(b), least_divisor))), spread};
}

Tracked sqrt(const Tracked& a) {
  const double root = Tracked::rounded(std::sqrt(a.value_));
  if (a.undefined_) return Tracked::undefined(root);
  const bool exact = fused(root, root, -a.value_) == 0 && (size(a) > format().safe_product || a.value_ == 0);
  if (!(a.value_ >= 0)) return {root, Tracked::infinite, Tracked::infinite};
  const double nearer = size(a) - a.spread_;
  const double spread =
      (nearer > 0 ? a.spread_ / (std::fabs(root) + std::sqrt(nearer)) : std::sqrt(size(a) + a.spread_)) + step(root);
  if (exact && a.error_ == 0) return {root, 0, spread};
  const double least = down(size(a) - a.error_);
  // Below the error the root is anything from 0 to sqrt(a + e).
  const double propagated =
      least > 0 ? over(a.error_, down(std::sqrt(least))) : std::nextafter(std::sqrt(plus(size(a), a.error_)), HUGE_VAL);
  return {root, plus(propagated, half_ulp(root)), spread};
}

Tracked acos(const Tracked& a) {
  const double angle = in_format([](auto x) { return std::acos(x); }, a.value_);
  if (a.undefined_) return Tracked::undefined(angle);
  if (plus(size(a), a.error_) > 1 && a.error_ > 0) Tracked::inconclusive() = true;
  const double spread = moved_angle(size(a), a.spread_) + 4 * step(angle);
  if (a.error_ == 0) return {angle, a.value_ == 1 ? 0 : 4 * half_ulp(angle), spread};
  return {angle, plus(moved_angle(size(a), a.error_), 4 * half_ulp(angle)), spread};
}

Tracked Tracked::library(double result, const Tracked& argument) {
  if (argument.undefined_) return undefined(result);
  const bool exact = argument.value_ == 0 && argument.error_ == 0;
  return {result, exact ? 0 : plus(argument.error_, 4 * half_ulp(result)), argument.spread_ + 4 * step(result)};
}
Tracked cos(const Tracked& a) {
  return Tracked::library(in_format([](auto x) { return std::cos(x); }, a.value_), a);
}
Tracked sin(const Tracked& a) {
  return Tracked::library(in_format([](auto x) { return std::sin(x); }, a.value_), a);
}

void Tracked::settled(const Tracked& a, const Tracked& b) {
  if (a.undefined_ || b.undefined_) return;
  const double gap = std::fabs(a.value_ - b.value_), error = plus(a.error_, b.error_);
  if (error > 0 && !(down(gap) > error)) inconclusive() = true;
  const double spread = a.spread_ + b.spread_;
  if (gap < nearest_comparison() * spread) nearest_comparison() = gap / spread;
  if (a.value_ != a.value_ || b.value_ != b.value_) inconclusive() = true;
}

}  // namespace touchstone::catalogue
