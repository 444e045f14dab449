// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <concepts>
#include <cstring>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>

#include "arithmetic/words.h"

namespace touchstone::arithmetic {
inline namespace TOUCHSTONE_WORDS {

/// The memory of numbers that are too long for the object.
struct Memory {
  void* (*take)(std::size_t bytes);
  void (*give)(void* piece, std::size_t bytes);
};
Memory& memory();

/// An integer of any size: sign and magnitude, without zeros above the highest digit; 0 has no digits and no sign. Up
/// to 256 bits need no memory beyond the object. The names of the members with get_ and set_ are those of GMP's C++
/// class.
class Integer {
 public:
  Integer() noexcept : own_{} {}
  template <std::integral T>
  Integer(T x) noexcept : own_{} {
    const bool minus = std::is_signed_v<T> && x < T{0};
    set_magnitude(minus ? 0 - static_cast<std::uint64_t>(x) : static_cast<std::uint64_t>(x));
    negative_ = minus;
  }
  template <std::floating_point T>
  Integer(T x) : own_{} {  // towards 0
    set_double(static_cast<double>(x));
  }
  explicit Integer(const std::string& digits, int base = 10) : own_{} { set_str(digits, base); }
  Integer(const Integer& b) : own_{} { assign(b); }
  Integer(Integer&& b) noexcept : own_{} { take(b); }
  Integer& operator=(const Integer& b) {
    if (this != &b) assign(b);
    return *this;
  }
  Integer& operator=(Integer&& b) noexcept {
    if (this != &b) release(), take(b);
    return *this;
  }
  ~Integer() { release(); }

  int sign() const { return size_ == 0 ? 0 : negative_ ? -1 : 1; }
  bool is_zero() const { return size_ == 0; }
  bool is_one() const { return size_ == 1 && words()[0] == 1 && !negative_; }
  bool odd() const { return size_ != 0 && (words()[0] & 1) != 0; }
  void negate() { negative_ = size_ != 0 && !negative_; }
  void set_negative(bool minus) { negative_ = size_ != 0 && minus; }

  // The magnitude:
  std::size_t size() const { return size_; }
  const Word* words() const { return capacity_ > own_words ? memory_ : own_; }
  /// 0 for 0.
  std::size_t bit_length() const {
    return size_ == 0 ? 0 : word_bits * size_ - static_cast<std::size_t>(std::countl_zero(words()[size_ - 1]));
  }
  /// Zeros below the lowest 1; all bits of a number for 0.
  std::uint64_t zeros() const;
  /// Bits 64 i to 64 i + 63.
  std::uint64_t bits64(std::size_t i = 0) const {
    if constexpr (word_bits == 64) return i < size_ ? words()[i] : 0;
    return word(2 * i) | static_cast<std::uint64_t>(word(2 * i + 1)) << 32;
  }
  /// The 64 bits from a place on.
  std::uint64_t bits64_from(std::size_t place) const;
  void set_bits64(const std::uint64_t* bits, std::size_t count);
  void set_bit(std::size_t place, bool one);
  std::uint64_t count_ones() const;

  static int compare_magnitudes(const Integer& a, const Integer& b) {
    return arithmetic::compare(a.words(), a.size_, b.words(), b.size_);
  }
  int compare(const Integer& b) const {
    if (negative_ != b.negative_) return negative_ ? -1 : 1;
    return negative_ ? -compare_magnitudes(*this, b) : compare_magnitudes(*this, b);
  }
  friend bool operator==(const Integer& a, const Integer& b) {
    return a.negative_ == b.negative_ && compare_magnitudes(a, b) == 0;
  }
  friend std::strong_ordering operator<=>(const Integer& a, const Integer& b) { return a.compare(b) <=> 0; }

  Integer& operator+=(const Integer& b) { return accumulate(b, b.negative_); }
  Integer& operator-=(const Integer& b) { return accumulate(b, !b.negative_); }
  Integer& operator*=(const Integer& b) { return *this = product(*this, b); }
  /// Towards 0; the rest has the sign of what is divided. The divisor is not 0.
  Integer& operator/=(const Integer& b) { return divide(*this, b, this, nullptr), *this; }
  Integer& operator%=(const Integer& b) { return divide(*this, b, nullptr, this), *this; }
  Integer& operator<<=(std::uint64_t bits);
  /// Towards minus infinity.
  Integer& operator>>=(std::uint64_t bits);
  /// Towards 0.
  void cut(std::uint64_t bits);
  Integer& operator++() { return *this += Integer(1); }
  Integer& operator--() { return *this -= Integer(1); }

  friend Integer operator+(const Integer& a, const Integer& b) { return Integer(a) += b; }
  friend Integer operator-(const Integer& a, const Integer& b) { return Integer(a) -= b; }
  friend Integer operator*(const Integer& a, const Integer& b) { return product(a, b); }
  friend Integer operator/(const Integer& a, const Integer& b) {
    Integer quotient;
    divide(a, b, &quotient, nullptr);
    return quotient;
  }
  friend Integer operator%(const Integer& a, const Integer& b) {
    Integer rest;
    divide(a, b, nullptr, &rest);
    return rest;
  }
  friend Integer operator<<(Integer a, std::uint64_t bits) { return std::move(a <<= bits); }
  friend Integer operator>>(Integer a, std::uint64_t bits) { return std::move(a >>= bits); }
  friend Integer operator+(Integer a) { return a; }
  friend Integer operator-(Integer a) {
    a.negate();
    return a;
  }
  /// The bits of the two's complement in a mask of 64 bits.
  friend Integer operator&(const Integer& a, std::uint64_t mask) {
    return Integer((a.negative_ ? 0 - a.bits64() : a.bits64()) & mask);
  }

  /// a = quotient b + rest, |rest| < |b|, both as above; either may be nullptr, a or b.
  static void divide(const Integer& a, const Integer& b, Integer* quotient, Integer* rest);

  std::uint64_t get_ui() const { return bits64(); }
  std::int64_t get_si() const { return static_cast<std::int64_t>(negative_ ? 0 - bits64() : bits64()); }
  /// Towards 0.
  double get_d() const;
  /// In [1/2, 1) or 0, towards 0; the number is about this times 2^exponent.
  double leading_digits(std::int64_t& exponent) const;
  std::string get_str(int base = 10) const;
  /// Returns -1, and keeps its value, where the text is no number.
  int set_str(const std::string& text, int base);
  Integer* get_mpz_t() { return this; }
  const Integer* get_mpz_t() const { return this; }

  friend Integer gcd(const Integer& a, const Integer& b);

 private:
  static constexpr std::uint32_t own_words = 256 / word_bits;

  Word* data() { return capacity_ > own_words ? memory_ : own_; }
  Word word(std::size_t i) const { return i < size_ ? words()[i] : 0; }
  void set_magnitude(std::uint64_t x) {
    Word* const w = data();
    w[0] = static_cast<Word>(x);
    if constexpr (word_bits == 32) w[1] = static_cast<Word>(x >> 32);
    size_ = word_bits == 32 && x >> 32 != 0 ? 2 : x != 0 ? 1 : 0, negative_ = false;
  }
  void set_double(double x);
  /// Makes room for so many words; the digits stay.
  void reserve(std::size_t words);
  void trim() {
    const Word* const w = words();
    while (size_ > 0 && w[size_ - 1] == 0) --size_;
    if (size_ == 0) negative_ = false;
  }
  void release() {
    if (capacity_ > own_words) memory().give(memory_, capacity_ * sizeof(Word)), capacity_ = own_words;
  }
  void take(Integer& b) noexcept {
    size_ = b.size_, capacity_ = b.capacity_, negative_ = b.negative_;
    if (capacity_ > own_words) memory_ = b.memory_;
    else std::memcpy(own_, b.own_, sizeof own_);
    b.size_ = 0, b.capacity_ = own_words, b.negative_ = false;
  }
  void assign(const Integer& b);
  /// Adds |b|, or subtracts it.
  Integer& accumulate(const Integer& b, bool minus);
  static Integer product(const Integer& a, const Integer& b);
  void divide_by_words(const Integer& b, Integer* rest);
  void lehmer_step(Integer& b);

  std::uint32_t size_ = 0, capacity_ = own_words;
  bool negative_ = false;
  union {
    Word own_[own_words];
    Word* memory_;
  };
};

inline int sgn(const Integer& a) { return a.sign(); }
inline int cmp(const Integer& a, const Integer& b) { return a.compare(b); }
inline Integer abs(Integer a) {
  a.set_negative(false);
  return a;
}
Integer gcd(const Integer& a, const Integer& b);
Integer lcm(const Integer& a, const Integer& b);
/// The greatest integer whose square is at most n, which is not negative.
Integer sqrt(const Integer& n);
/// The same with a power; power >= 1.
Integer root(const Integer& n, std::uint64_t power);
bool is_square(const Integer& n);
Integer power(Integer base, std::uint64_t exponent);
inline void swap(Integer& a, Integer& b) noexcept { std::swap(a, b); }
inline std::ostream& operator<<(std::ostream& out, const Integer& a) { return out << a.get_str(); }

}  // namespace TOUCHSTONE_WORDS
}  // namespace touchstone::arithmetic
