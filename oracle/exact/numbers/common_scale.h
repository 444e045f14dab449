// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "geometry/thin_shapes.h"
#include "oracle/exact/numbers/wide.h"

namespace touchstone::oracle {

/// Numbers written as integers times one positive unit: number i is whole(i) units. Signs of determinants and ratios of
/// lengths do not change under that scale, so geometry can be done on the integers.
///
/// Doubles have a power of two as their unit, rationals one over their least common denominator.
template <class Number, std::size_t N>
class CommonScale;

template <std::size_t N>
class CommonScale<double, N> {
 public:
  explicit CommonScale(const std::array<double, N>& numbers) {
    for (std::size_t i = 0; i < N; ++i) {
      parts_[i] = decode(numbers[i]);
      finite_ = finite_ && parts_[i].exponent != decode_infinite;
    }
    measure();
    if (bits_ > 61) {  // a common factor of two may bring the numbers back within one machine word
      for (Dyadic& part : parts_) {
        if (part.mantissa == 0) continue;
        const int zeros = std::countr_zero(static_cast<std::uint64_t>(part.mantissa));
        part.mantissa >>= zeros;
        part.exponent += zeros;
      }
      measure();
    }
  }

  /// True if there is no infinity or NaN among the doubles; otherwise the rest of this class is meaningless.
  bool finite() const { return finite_; }

  /// Every |whole(i)| < 2^bits().
  int bits() const { return bits_; }

  /// Integer i in a machine word; only if bits() <= 63.
  std::int64_t word(std::size_t i) const {
    return parts_[i].mantissa == 0 ? 0 : parts_[i].mantissa << (parts_[i].exponent - exponent_);
  }

  Integer integer(std::size_t i) const {
    Integer result(static_cast<std::int64_t>(parts_[i].mantissa));
    if (parts_[i].mantissa != 0) result <<= static_cast<mp_bitcnt_t>(parts_[i].exponent - exponent_);
    return result;
  }

  /// value * unit^degree
  Rational actual(Rational value, int degree) const { return scaled(std::move(value), degree * exponent_); }

 private:
  void measure() {
    int least = 4096, top = -4096;
    for (const Dyadic& part : parts_) {
      if (part.mantissa == 0) continue;
      const auto magnitude = static_cast<std::uint64_t>(part.mantissa < 0 ? -part.mantissa : part.mantissa);
      least = std::min(least, part.exponent);
      top = std::max(top, part.exponent + static_cast<int>(std::bit_width(magnitude)));
    }
    const bool all_zero = least == 4096;
    exponent_ = all_zero ? 0 : least;
    bits_ = all_zero ? 0 : top - least;
  }

  std::array<Dyadic, N> parts_;
  int exponent_ = 0, bits_ = 0;
  bool finite_ = true;
};

template <std::size_t N>
class CommonScale<Rational, N> {
 public:
  explicit CommonScale(const std::array<Rational, N>& numbers) : denominator_(1) {
    for (const Rational& number : numbers) {
      mpz_lcm(denominator_.get_mpz_t(), denominator_.get_mpz_t(), number.get_den_mpz_t());
    }
    for (std::size_t i = 0; i < N; ++i) {
      wholes_[i] = numbers[i].get_num() * (denominator_ / numbers[i].get_den());
      bits_ = std::max(bits_, static_cast<int>(mpz_sizeinbase(wholes_[i].get_mpz_t(), 2)));
    }
  }

  bool finite() const { return true; }
  int bits() const { return bits_; }
  std::int64_t word(std::size_t i) const { return wholes_[i].get_si(); }
  const Integer& integer(std::size_t i) const { return wholes_[i]; }

  Rational actual(const Rational& value, int degree) const {
    Integer power;
    mpz_pow_ui(power.get_mpz_t(), denominator_.get_mpz_t(), static_cast<std::uint64_t>(degree));
    return Rational(value / Rational(power));
  }

 private:
  std::array<Integer, N> wholes_;
  Integer denominator_;
  int bits_ = 0;
};

/// Integers of this size and their differences, and sums of a few products of two of those, fit Int128.
constexpr int most_bits_in_words = 61;

/// Numbers i and i + 1 as a point, i to i + 3 as a segment. Value: Integer, or Int128 if bits() <= most_bits_in_words.
template <class Value, class Scale>
Value integer(const Scale& scale, std::size_t i) {
  if constexpr (std::is_same_v<Value, Integer>) {
    return scale.integer(i);
  } else {
    return scale.word(i);
  }
}
template <class Value = Integer, class Scale>
Point2<Value> integer_point(const Scale& scale, std::size_t i) {
  return {integer<Value>(scale, i), integer<Value>(scale, i + 1)};
}
template <class Value = Integer, class Scale>
Segment2<Value> integer_segment(const Scale& scale, std::size_t i) {
  return {integer_point<Value>(scale, i), integer_point<Value>(scale, i + 2)};
}

/// A point in units, unchanged.
template <class Scale>
Point2<Rational> actual_point(const Scale& scale, Point2<Rational> point) {
  return {scale.actual(std::move(point.x), 1), scale.actual(std::move(point.y), 1)};
}

}  // namespace touchstone::oracle
