// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

#include "oracle/exact/decode.h"

namespace touchstone::oracle {

/// Doubles written as integers times one power of two: number i is whole(i) * 2^exponent(). Signs of determinants and
/// ratios of lengths do not change under that scale, so geometry can be done on the integers.
template <std::size_t N>
class CommonPower {
 public:
  explicit CommonPower(const std::array<double, N>& numbers) {
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

  /// No infinity or NaN among the doubles; without that nothing else here means anything.
  bool finite() const { return finite_; }

  int exponent() const { return exponent_; }

  /// Every |whole(i)| < 2^bits().
  int bits() const { return bits_; }

  /// Whole number i in a machine word; only where bits() <= 63.
  std::int64_t word(std::size_t i) const {
    return parts_[i].mantissa == 0 ? 0 : parts_[i].mantissa << (parts_[i].exponent - exponent_);
  }

  Integer whole(std::size_t i) const {
    Integer result(static_cast<long>(parts_[i].mantissa));
    if (parts_[i].mantissa != 0) result <<= static_cast<mp_bitcnt_t>(parts_[i].exponent - exponent_);
    return result;
  }

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

}  // namespace touchstone::oracle
