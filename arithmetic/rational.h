// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "arithmetic/integer.h"

namespace touchstone::arithmetic {
inline namespace TOUCHSTONE_WORDS {

class Floating;

/// A rational number in lowest terms, its denominator positive; a constructor from two numbers leaves that to
/// canonicalize(), as GMP's does.
class Rational {
 public:
  Rational() : denominator_(1) {}
  template <std::integral T>
  Rational(T x) : numerator_(x), denominator_(1) {}
  template <std::floating_point T>
  Rational(T x) : denominator_(1) {
    set_double(static_cast<double>(x));
  }
  Rational(const Integer& x) : numerator_(x), denominator_(1) {}
  Rational(const Integer& above, const Integer& below) : numerator_(above), denominator_(below) {}
  explicit Rational(const Floating& x);
  explicit Rational(const std::string& text) : denominator_(1) { set_str(text, 10); }

  Integer& get_num() { return numerator_; }
  Integer& get_den() { return denominator_; }
  const Integer& get_num() const { return numerator_; }
  const Integer& get_den() const { return denominator_; }
  Integer* get_num_mpz_t() { return &numerator_; }
  Integer* get_den_mpz_t() { return &denominator_; }
  const Integer* get_num_mpz_t() const { return &numerator_; }
  const Integer* get_den_mpz_t() const { return &denominator_; }
  Rational* get_mpq_t() { return this; }
  const Rational* get_mpq_t() const { return this; }
  explicit operator Integer() const { return numerator_ / denominator_; }  // towards 0

  void canonicalize();
  /// Towards 0.
  double get_d() const;
  std::string get_str(int base = 10) const;
  int set_str(const std::string& text, int base);
  void negate() { numerator_.negate(); }
  /// Multiplies by 2^exponent.
  void scale(std::int64_t exponent);

  Rational& operator+=(const Rational& b) { return *this = sum(*this, b, false); }
  Rational& operator-=(const Rational& b) { return *this = sum(*this, b, true); }
  Rational& operator*=(const Rational& b) {
    return *this = product(numerator_, denominator_, b.numerator_, b.denominator_);
  }
  /// b is not 0.
  Rational& operator/=(const Rational& b) {
    return *this = product(numerator_, denominator_, b.denominator_, b.numerator_);
  }
  Rational& operator<<=(std::uint64_t bits) { return scale(static_cast<std::int64_t>(bits)), *this; }
  Rational& operator>>=(std::uint64_t bits) { return scale(-static_cast<std::int64_t>(bits)), *this; }
  friend Rational operator+(const Rational& a, const Rational& b) { return sum(a, b, false); }
  friend Rational operator-(const Rational& a, const Rational& b) { return sum(a, b, true); }
  friend Rational operator*(const Rational& a, const Rational& b) {
    return product(a.numerator_, a.denominator_, b.numerator_, b.denominator_);
  }
  friend Rational operator/(const Rational& a, const Rational& b) {
    return product(a.numerator_, a.denominator_, b.denominator_, b.numerator_);
  }
  friend Rational operator<<(Rational a, std::uint64_t bits) { return std::move(a <<= bits); }
  friend Rational operator>>(Rational a, std::uint64_t bits) { return std::move(a >>= bits); }
  friend Rational operator+(Rational a) { return a; }
  friend Rational operator-(Rational a) {
    a.negate();
    return a;
  }
  int compare(const Rational& b) const;
  friend bool operator==(const Rational& a, const Rational& b) {
    return a.numerator_ == b.numerator_ && a.denominator_ == b.denominator_;
  }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) { return a.compare(b) <=> 0; }

 private:
  static Rational of_lowest(Integer above, Integer below) {
    Rational result;
    result.numerator_ = std::move(above), result.denominator_ = std::move(below);
    return result;
  }
  void set_double(double x);
  static Rational sum(const Rational& a, const Rational& b, bool minus);
  /// (a / b) (c / d); d may be negative.
  static Rational product(const Integer& a, const Integer& b, const Integer& c, const Integer& d);

  Integer numerator_, denominator_;
};

inline int sgn(const Rational& a) { return a.get_num().sign(); }
inline int cmp(const Rational& a, const Rational& b) { return a.compare(b); }
inline Rational abs(Rational a) {
  a.get_num().set_negative(false);
  return a;
}
inline void swap(Rational& a, Rational& b) noexcept { std::swap(a, b); }
inline std::ostream& operator<<(std::ostream& out, const Rational& a) { return out << a.get_str(); }

}  // namespace TOUCHSTONE_WORDS
}  // namespace touchstone::arithmetic
