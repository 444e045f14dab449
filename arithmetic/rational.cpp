// SPDX-License-Identifier: Apache-2.0
#include "arithmetic/rational.h"

#include <algorithm>
#include <cmath>

namespace touchstone::arithmetic {
inline namespace TOUCHSTONE_WORDS {

void Rational::canonicalize() {
  if (denominator_.sign() < 0) numerator_.negate(), denominator_.negate();
  const Integer common = gcd(numerator_, denominator_);
  if (!common.is_one()) numerator_ /= common, denominator_ /= common;
}

void Rational::set_double(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto field = static_cast<std::int64_t>(bits >> 52 & 0x7ff);
  const std::uint64_t fraction = bits & 0xfffffffffffffu;
  numerator_ = Integer(field == 0 ? fraction : fraction | 0x10000000000000u);
  scale(std::max<std::int64_t>(field, 1) - 1075);
  numerator_.set_negative(bits >> 63 != 0);
}

void Rational::scale(std::int64_t exponent) {
  if (numerator_.is_zero()) return;
  Integer &grows = exponent < 0 ? denominator_ : numerator_, &shrinks = exponent < 0 ? numerator_ : denominator_;
  const auto bits = static_cast<std::uint64_t>(exponent < 0 ? -exponent : exponent);
  const std::uint64_t common = std::min(bits, shrinks.zeros());
  shrinks.cut(common);
  grows <<= bits - common;
}

double Rational::get_d() const {
  if (numerator_.is_zero()) return 0;
  const std::int64_t up =
      64 - static_cast<std::int64_t>(numerator_.bit_length()) + static_cast<std::int64_t>(denominator_.bit_length());
  const auto by = static_cast<std::uint64_t>(up < 0 ? -up : up);
  const Integer quotient = up < 0 ? numerator_ / (denominator_ << by) : (numerator_ << by) / denominator_;
  // The digits of a subnormal number end earlier.
  const std::int64_t lowest = static_cast<std::int64_t>(quotient.bit_length()) - 53, least = up - 1074;
  const std::int64_t place = std::max({lowest, least, std::int64_t{0}});
  Integer digits = quotient;
  digits.cut(static_cast<std::uint64_t>(place));
  const double found = static_cast<double>(digits.get_si());
  return std::ldexp(found, static_cast<int>(std::clamp<std::int64_t>(place - up, -5000, 5000)));
}

std::string Rational::get_str(int base) const {
  return denominator_.is_one() ? numerator_.get_str(base) : numerator_.get_str(base) + "/" + denominator_.get_str(base);
}

int Rational::set_str(const std::string& text, int base) {
  const std::size_t bar = text.find('/');
  if (numerator_.set_str(text.substr(0, bar), base) != 0) return -1;
  denominator_ = Integer(1);
  return bar == std::string::npos ? 0 : denominator_.set_str(text.substr(bar + 1), base);
}

/// P. Henrici, A subroutine for computations with rational numbers (1956): common divisors are looked for where they
/// may be, in numbers half as long. So in the product.
Rational Rational::sum(const Rational& a, const Rational& b, bool minus) {
  const auto plus = [minus](const Integer& x, const Integer& y) { return minus ? x - y : x + y; };
  const Integer &over_a = a.denominator_, &over_b = b.denominator_;
  if (over_a.is_one() && over_b.is_one()) return of_lowest(plus(a.numerator_, b.numerator_), over_a);
  const Integer common = gcd(over_a, over_b);
  if (common.is_one()) return of_lowest(plus(a.numerator_ * over_b, b.numerator_ * over_a), over_a * over_b);
  const Integer rest = over_a / common;
  Integer above = plus(a.numerator_ * (over_b / common), b.numerator_ * rest);
  const Integer left = gcd(above, common);
  if (left.is_one()) return of_lowest(std::move(above), rest * over_b);
  return of_lowest(above / left, rest * (over_b / left));
}

Rational Rational::product(const Integer& a, const Integer& b, const Integer& c, const Integer& d) {
  if (a.is_zero() || c.is_zero()) return {};
  if (b.is_one() && d.is_one()) return of_lowest(a * c, b);
  const Integer across = d.is_one() ? d : gcd(a, d), other = b.is_one() ? b : gcd(c, b);
  const auto over = [](const Integer& x, const Integer& y) { return y.is_one() ? x : x / y; };
  Rational result = of_lowest(over(a, across) * over(c, other), over(b, other) * over(d, across));
  if (d.sign() < 0) result.numerator_.negate(), result.denominator_.negate();
  return result;
}

int Rational::compare(const Rational& b) const {
  const int sign = numerator_.sign(), other = b.numerator_.sign();
  if (sign != other || sign == 0) return sign - other;
  if (denominator_ == b.denominator_) return numerator_.compare(b.numerator_);
  const std::size_t left = numerator_.bit_length() + b.denominator_.bit_length(),
                    right = b.numerator_.bit_length() + denominator_.bit_length();
  if (left > right + 1) return sign;
  if (right > left + 1) return -sign;
  return (numerator_ * b.denominator_).compare(b.numerator_ * denominator_);
}

}  // namespace TOUCHSTONE_WORDS
}  // namespace touchstone::arithmetic
