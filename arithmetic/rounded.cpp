// SPDX-License-Identifier: Apache-2.0
#include "arithmetic/rounded.h"

#include <algorithm>

#include "arithmetic/enclosures.h"

namespace touchstone::arithmetic {
inline namespace TOUCHSTONE_WORDS {
namespace {

std::int64_t bits_of(const Integer& n) { return static_cast<std::int64_t>(n.bit_length()); }
std::uint64_t places(std::int64_t n) { return static_cast<std::uint64_t>(n); }

/// The number lies at n 2^exponent, or, if `more`, a little farther from 0, but nearer than the next of two bits more
/// than the result has.
void round_magnitude(Rounded& result, const Integer& n, std::int64_t exponent, bool more, Rounding mode) {
  const bool negative = n.sign() < 0;
  Integer digits = abs(n);
  if (const std::int64_t drop = bits_of(digits) - result.precision; drop > 0) {
    const bool half = (digits.bits64_from(places(drop - 1)) & 1) != 0, rest = digits.zeros() < places(drop - 1) || more;
    digits.cut(places(drop));
    const bool away = mode == Rounding::nearest ? half && (rest || digits.odd())
                      : mode == Rounding::up    ? !negative && (half || rest)
                                                : mode == Rounding::down && negative && (half || rest);
    exponent += drop;
    if (away) ++digits;
    if (bits_of(digits) > result.precision) digits.cut(1), ++exponent;
  } else {
    digits <<= places(-drop), exponent += drop;
  }
  digits.set_negative(negative);
  result.digits = std::move(digits), result.exponent = exponent;
}

/// Rounds where both ends of an enclosure round alike.
bool settle(Rounded& result, const Near& near, std::int64_t bits, Rounding mode) {
  if (abs(near.n) <= near.error) return false;
  Rounded low, high;
  low.precision = high.precision = result.precision;
  round(low, near.n - near.error, -bits, mode), round(high, near.n + near.error, -bits, mode);
  if (low.digits != high.digits || low.exponent != high.exponent) return false;
  result = std::move(low);
  return true;
}

/// Asks for more and more bits. It ends, for what is asked here is transcendental (Lindemann), so that it is no halfway
/// case; the caller has handled what is not.
template <class Enclose>
void round_enclosed(Rounded& result, Rounding mode, const Enclose& enclose) {
  for (std::int64_t bits = result.precision + 64; !settle(result, enclose(bits), bits, mode); bits += bits / 2)
    continue;
}

}  // namespace

Rational Rounded::value() const {
  Rational result(digits);
  result.scale(exponent);
  return result;
}

Integer Rounded::nearest_integer() const {
  if (exponent >= 0) return digits << places(exponent);
  const Integer half = Integer(1) << places(-exponent - 1);
  Integer found = (digits + half) >> places(-exponent);
  const bool halfway = digits.zeros() == places(-exponent - 1);
  if (halfway && found.odd()) --found;
  return found;
}

void round(Rounded& result, const Integer& n, std::int64_t exponent, Rounding mode) {
  round_magnitude(result, n, exponent, false, mode);
}

void round_quotient(Rounded& result, const Integer& a, const Integer& b, std::int64_t exponent, Rounding mode) {
  const std::int64_t up = std::max<std::int64_t>(result.precision + 3 + bits_of(b) - bits_of(a), 0);
  Integer quotient, rest;
  Integer::divide(a << places(up), b, &quotient, &rest);
  round_magnitude(result, quotient, exponent - up, !rest.is_zero(), mode);
}

void round_sum(Rounded& result, const Rounded& a, const Rounded& b, Rounding mode) {
  const std::int64_t least = std::min(a.exponent, b.exponent);
  round(result, (a.digits << places(a.exponent - least)) + (b.digits << places(b.exponent - least)), least, mode);
}

void round_square_root(Rounded& result, const Rounded& a, Rounding mode) {
  std::int64_t up = std::max<std::int64_t>(2 * (result.precision + 3) - bits_of(a.digits), 0);
  if ((a.exponent - up) % 2 != 0) ++up;
  const Integer n = a.digits << places(up), root = sqrt(n);
  round_magnitude(result, root, (a.exponent - up) / 2, root * root != n, mode);
}

void round_pi(Rounded& result, Rounding mode) {
  round_enclosed(result, mode, [](std::int64_t bits) { return pi(bits); });
}

void round_sine_cosine(Rounded* sine, Rounded* cosine, const Rounded& angle, Rounding mode) {
  if (angle.digits.is_zero()) {
    if (sine != nullptr) round(*sine, 0, 0, mode);
    if (cosine != nullptr) round(*cosine, 1, 0, mode);
    return;
  }
  const Rounded of = angle;
  // A small angle has a small sine: its bits count from the first that is not 0.
  const std::int64_t small = std::max<std::int64_t>(-of.exponent - bits_of(of.digits), 0);
  std::int64_t bits =
      std::max(sine != nullptr ? sine->precision + small : 0, cosine != nullptr ? cosine->precision : 0) + 64;
  for (;; bits += bits / 2) {
    const auto [up, along] = sine_cosine(of.digits, of.exponent, bits);
    if (sine != nullptr && settle(*sine, up, bits, mode)) sine = nullptr;
    if (cosine != nullptr && settle(*cosine, along, bits, mode)) cosine = nullptr;
    if (sine == nullptr && cosine == nullptr) return;
  }
}

void round_arc_tangent(Rounded& result, const Rounded& y, const Rounded& x, Rounding mode) {
  const std::int64_t least = std::min(y.exponent, x.exponent);
  const Integer up = y.digits << places(y.exponent - least), along = x.digits << places(x.exponent - least);
  if (up.is_zero() && along.sign() >= 0) return round(result, 0, 0, mode);
  round_enclosed(result, mode, [&](std::int64_t bits) { return arc_tangent(up, along, bits); });
}

void round_arc_cosine(Rounded& result, const Rounded& x, Rounding mode) {
  const std::int64_t down = std::max<std::int64_t>(-x.exponent, 0);
  const Integer n = x.digits << places(x.exponent + down);
  if (n == Integer(1) << places(down)) return round(result, 0, 0, mode);
  round_enclosed(result, mode, [&](std::int64_t bits) { return arc_cosine(n, down, bits); });
}

}  // namespace TOUCHSTONE_WORDS
}  // namespace touchstone::arithmetic
