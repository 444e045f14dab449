// SPDX-License-Identifier: Apache-2.0
#include "arithmetic/floating.h"

#include <algorithm>
#include <cmath>

namespace touchstone::arithmetic {
inline namespace TOUCHSTONE_WORDS {
namespace {

std::int64_t bits_of(const Integer& n) { return static_cast<std::int64_t>(n.bit_length()); }
std::uint64_t size_of(std::int64_t n) { return static_cast<std::uint64_t>(n < 0 ? -n : n); }

}  // namespace

Rational::Rational(const Floating& x) : numerator_(x.digits()), denominator_(1) { scale(x.exponent()); }

void Floating::cut() {
  const std::int64_t more = bits_of(digits_) - precision_ - 64;
  if (more > 0) digits_.cut(size_of(more)), exponent_ += more;
  if (digits_.is_zero()) exponent_ = 0;
}

Floating& Floating::operator=(const Rational& x) {
  exponent_ = bits_of(x.get_num()) - bits_of(x.get_den()) - precision_ - 64;
  digits_ = exponent_ < 0 ? (x.get_num() << size_of(exponent_)) / x.get_den()
                          : x.get_num() / (x.get_den() << size_of(exponent_));
  cut();
  return *this;
}

Floating Floating::sum(const Floating& a, const Floating& b, bool minus) {
  const std::int64_t least = a.digits_.is_zero()   ? b.exponent_
                             : b.digits_.is_zero() ? a.exponent_
                                                   : std::min(a.exponent_, b.exponent_);
  const Integer x = a.digits_ << size_of(std::max<std::int64_t>(a.exponent_ - least, 0)),
                y = b.digits_ << size_of(std::max<std::int64_t>(b.exponent_ - least, 0));
  return {minus ? x - y : x + y, least, std::max(a.precision_, b.precision_)};
}

Integer Floating::exact_difference(const Floating& a, const Floating& b) {
  return sum(Floating(a, 1 << 30), b, true).digits_;
}

Floating operator/(const Floating& a, const Floating& b) {
  const std::int64_t precision = std::max(a.precision_, b.precision_);
  const std::int64_t up = std::max<std::int64_t>(precision + 64 + bits_of(b.digits_) - bits_of(a.digits_), 0);
  return {(a.digits_ << size_of(up)) / b.digits_, a.exponent_ - up - b.exponent_, precision};
}

Floating sqrt(const Floating& a) {
  std::int64_t up = std::max<std::int64_t>(2 * (a.precision_ + 64) - bits_of(a.digits_), 0);
  if ((a.exponent_ - up) % 2 != 0) ++up;
  return {sqrt(a.digits_ << size_of(up)), (a.exponent_ - up) / 2, a.precision_};
}

std::string Floating::get_str(std::int64_t& point, int base, std::size_t most) const {
  point = 0;
  if (digits_.is_zero()) return "";
  const Rational size = abs(Rational(*this)), scale(base);
  // A guess of the logarithm, which is then corrected.
  point =
      static_cast<std::int64_t>(std::floor(static_cast<double>(bits_of(digits_) + exponent_) / std::log2(base))) + 1;
  for (;;) {
    const std::int64_t places = static_cast<std::int64_t>(most) - point;
    const Rational moved = power(Integer(base), size_of(places)), digits = places < 0 ? size / moved : size * moved;
    const std::size_t count = digits < 1 ? 0 : Integer(digits).get_str(base).size();
    if (count != most) {
      point += count < most ? -1 : 1;
      continue;
    }
    std::string text = Integer(digits + Rational(1, 2)).get_str(base);
    if (text.size() > most) ++point;
    text.erase(text.find_last_not_of('0') + 1);
    return digits_.sign() < 0 ? "-" + text : text;
  }
}

std::string general_text(const Floating& x, int most) {
  std::int64_t point = 0;
  std::string digits = x.get_str(point, 10, static_cast<std::size_t>(most));
  if (digits.empty()) return "0";
  const std::string sign = digits[0] == '-' ? "-" : "";
  digits.erase(0, sign.size());
  const auto count = static_cast<std::int64_t>(digits.size());
  if (const std::int64_t exponent = point - 1; exponent < -4 || exponent >= most) {
    const std::string power = std::to_string(size_of(exponent));
    return sign + digits.substr(0, 1) + (count > 1 ? "." + digits.substr(1) : "") + (exponent < 0 ? "e-" : "e+") +
           (power.size() < 2 ? "0" : "") + power;
  }
  if (point <= 0) return sign + "0." + std::string(size_of(point), '0') + digits;
  if (count <= point) return sign + digits + std::string(size_of(point - count), '0');
  return sign + digits.substr(0, size_of(point)) + "." + digits.substr(size_of(point));
}

}  // namespace TOUCHSTONE_WORDS
}  // namespace touchstone::arithmetic
