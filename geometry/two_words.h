// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <compare>
#include <concepts>
#include <cstdint>
#include <type_traits>

namespace touchstone {

/// An integer of 128 bits as two words, for compilers without __int128, which it follows: two's complement, results
/// modulo 2^128, quotients truncated, arithmetic right shifts. Integers of at most 64 bits convert to it, and a signed
/// one to an unsigned one; all other conversions are explicit. Shifts are by 0 to 127 places.
template <bool is_signed>
class TwoWords {
 public:
  constexpr TwoWords() = default;
  template <std::integral Integer>
  constexpr TwoWords(Integer value) : low_(static_cast<std::uint64_t>(value)) {
    if constexpr (std::is_signed_v<Integer>) high_ = value < 0 ? ~std::uint64_t{0} : 0;
  }
  template <bool other>
  requires(other != is_signed) constexpr explicit(is_signed) TwoWords(const TwoWords<other>& value)
      : high_(value.high_), low_(value.low_) {}

  template <std::integral Integer>
  constexpr explicit operator Integer() const {
    if constexpr (std::is_same_v<Integer, bool>) return (high_ | low_) != 0;
    else return static_cast<Integer>(low_);
  }

  constexpr TwoWords operator~() const { return {~high_, ~low_}; }
  constexpr TwoWords operator-() const { return {~high_ + (low_ == 0), ~low_ + 1}; }

  friend constexpr TwoWords operator+(const TwoWords& a, const TwoWords& b) {
    const std::uint64_t low = a.low_ + b.low_;
    return {a.high_ + b.high_ + (low < a.low_), low};
  }
  friend constexpr TwoWords operator-(const TwoWords& a, const TwoWords& b) {
    return {a.high_ - b.high_ - (a.low_ < b.low_), a.low_ - b.low_};
  }
  friend constexpr TwoWords operator*(const TwoWords& a, const TwoWords& b) {
    const std::uint64_t half = 0xffffffff, a1 = a.low_ >> 32, a0 = a.low_ & half, b1 = b.low_ >> 32, b0 = b.low_ & half;
    const std::uint64_t bottom = a0 * b0, left = a1 * b0, right = a0 * b1;
    const std::uint64_t middle = (bottom >> 32) + (left & half) + (right & half);
    const std::uint64_t carried = a1 * b1 + (left >> 32) + (right >> 32) + (middle >> 32);
    return {a.high_ * b.low_ + a.low_ * b.high_ + carried, middle << 32 | (bottom & half)};
  }
  friend constexpr TwoWords operator/(const TwoWords& a, const TwoWords& b) {
    const TwoWords size = divide(a, b).quotient;
    return a.negative() != b.negative() ? -size : size;
  }
  friend constexpr TwoWords operator%(const TwoWords& a, const TwoWords& b) {
    const TwoWords size = divide(a, b).remainder;
    return a.negative() ? -size : size;
  }

  friend constexpr TwoWords operator&(const TwoWords& a, const TwoWords& b) {
    return {a.high_ & b.high_, a.low_ & b.low_};
  }
  friend constexpr TwoWords operator|(const TwoWords& a, const TwoWords& b) {
    return {a.high_ | b.high_, a.low_ | b.low_};
  }
  friend constexpr TwoWords operator^(const TwoWords& a, const TwoWords& b) {
    return {a.high_ ^ b.high_, a.low_ ^ b.low_};
  }
  friend constexpr TwoWords operator<<(const TwoWords& a, std::int64_t places) {
    if (places == 0) return a;
    if (places >= 64) return {a.low_ << (places - 64), 0};
    return {a.high_ << places | a.low_ >> (64 - places), a.low_ << places};
  }
  friend constexpr TwoWords operator>>(const TwoWords& a, std::int64_t places) {
    const auto shifted = static_cast<std::uint64_t>(static_cast<Top>(a.high_) >> (places & 63));
    if (places == 0) return a;
    if (places >= 64) return {a.negative() ? ~std::uint64_t{0} : 0, shifted};
    return {shifted, a.low_ >> places | a.high_ << (64 - places)};
  }

  constexpr TwoWords& operator+=(const TwoWords& b) { return *this = *this + b; }
  constexpr TwoWords& operator-=(const TwoWords& b) { return *this = *this - b; }
  constexpr TwoWords& operator*=(const TwoWords& b) { return *this = *this * b; }
  constexpr TwoWords& operator<<=(std::int64_t places) { return *this = *this << places; }
  constexpr TwoWords& operator>>=(std::int64_t places) { return *this = *this >> places; }

  friend constexpr bool operator==(const TwoWords& a, const TwoWords& b) = default;
  friend constexpr std::strong_ordering operator<=>(const TwoWords& a, const TwoWords& b) {
    const std::strong_ordering order = static_cast<Top>(a.high_) <=> static_cast<Top>(b.high_);
    return order != 0 ? order : a.low_ <=> b.low_;
  }

 private:
  using Top = std::conditional_t<is_signed, std::int64_t, std::uint64_t>;
  friend class TwoWords<!is_signed>;
  struct Division {
    TwoWords quotient, remainder;
  };

  constexpr TwoWords(std::uint64_t high, std::uint64_t low) : high_(high), low_(low) {}
  constexpr bool negative() const { return is_signed && high_ >> 63 != 0; }
  /// Divides the magnitudes, digit by digit.
  static constexpr Division divide(const TwoWords& a, const TwoWords& b) {
    const TwoWords<false> above = a.negative() ? -a : a, below = b.negative() ? -b : b;
    TwoWords<false> quotient, rest;
    for (int place = 127; place >= 0; --place) {
      const bool carried = rest.high_ >> 63 != 0;
      rest = rest << 1 | (above >> place & 1);
      quotient <<= 1;
      if (carried || rest >= below) rest -= below, quotient.low_ |= 1;
    }
    return {TwoWords(quotient.high_, quotient.low_), TwoWords(rest.high_, rest.low_)};
  }

  std::uint64_t high_ = 0, low_ = 0;
};

}  // namespace touchstone
