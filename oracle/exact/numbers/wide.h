// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmp.h>

#include <bit>
#include <cstdint>

#include "oracle/exact/numbers/decode.h"

namespace touchstone::oracle {

constexpr UInt128 magnitude(Int128 value) {
  return value < 0 ? -static_cast<UInt128>(value) : static_cast<UInt128>(value);
}

/// 256 bits, two's complement: the product of two Int128 and differences of such products, without memory of its own.
struct Wide {
  UInt128 low;
  Int128 high;

  friend constexpr bool operator==(const Wide& a, const Wide& b) { return a.low == b.low && a.high == b.high; }
  friend constexpr bool operator<(const Wide& a, const Wide& b) {
    return a.high != b.high ? a.high < b.high : a.low < b.low;
  }
  friend constexpr Wide operator-(const Wide& a, const Wide& b) {
    const auto high = static_cast<UInt128>(a.high) - static_cast<UInt128>(b.high) - (a.low < b.low);
    return {a.low - b.low, static_cast<Int128>(high)};
  }
  friend constexpr int sgn(const Wide& a) { return a.high < 0 ? -1 : a.high > 0 || a.low > 0 ? 1 : 0; }
};

constexpr int sgn(Int128 value) { return (value > 0) - (value < 0); }

constexpr Wide product(Int128 a, Int128 b) {
  const UInt128 x = magnitude(a), y = magnitude(b);
  const auto x0 = static_cast<std::uint64_t>(x), x1 = static_cast<std::uint64_t>(x >> 64);
  const auto y0 = static_cast<std::uint64_t>(y), y1 = static_cast<std::uint64_t>(y >> 64);
  const UInt128 bottom = UInt128{x0} * y0, middle = UInt128{x1} * y0, other = UInt128{x0} * y1;
  const UInt128 carried = (bottom >> 64) + static_cast<std::uint64_t>(middle) + static_cast<std::uint64_t>(other);
  const UInt128 high = UInt128{x1} * y1 + (middle >> 64) + (other >> 64) + (carried >> 64);
  const Wide size{carried << 64 | static_cast<std::uint64_t>(bottom), static_cast<Int128>(high)};
  return (a < 0) != (b < 0) ? Wide{0, 0} - size : size;
}
inline Integer product(const Integer& a, const Integer& b) { return Integer(a * b); }

/// Divides numbers repeatedly by one divisor, which divides them without remainder.
template <class Value>
class ExactDivision;

template <>
class ExactDivision<Int128> {
 public:
  constexpr explicit ExactDivision(Int128 divisor) {
    const auto low = static_cast<std::uint64_t>(divisor);
    twos_ = low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(static_cast<std::uint64_t>(divisor >> 64));
    const auto odd = static_cast<UInt128>(divisor >> twos_);
    inverse_ = odd;  // right modulo 2^3; each step doubles the number of right bits
    for (int bits = 3; bits < 128; bits *= 2) inverse_ *= 2 - odd * inverse_;
  }

  /// The quotient, if it fits 128 bits: modulo 2^128 a division is a multiplication by the inverse.
  constexpr Int128 operator()(const Wide& value) const {
    const UInt128 shifted =
        twos_ == 0 ? value.low : value.low >> twos_ | static_cast<UInt128>(value.high) << (128 - twos_);
    return static_cast<Int128>(shifted * inverse_);
  }

 private:
  int twos_;
  UInt128 inverse_;
};

template <>
class ExactDivision<Integer> {
 public:
  explicit ExactDivision(const Integer& divisor) : divisor_(divisor), one_(divisor == 1) {}

  void in_place(Integer& value) const {
    if (!one_) mpz_divexact(value.get_mpz_t(), value.get_mpz_t(), divisor_.get_mpz_t());
  }
  Integer operator()(Integer value) const {
    in_place(value);
    return value;
  }

 private:
  Integer divisor_;
  bool one_;
};

/// A read-only GMP integer on the stack.
class View {
 public:
  explicit View(const Wide& value) {
    const Wide size = value.high < 0 ? Wide{0, 0} - value : value;
    const auto high = static_cast<UInt128>(size.high);
    limbs_[0] = static_cast<mp_limb_t>(size.low), limbs_[1] = static_cast<mp_limb_t>(size.low >> 64);
    limbs_[2] = static_cast<mp_limb_t>(high), limbs_[3] = static_cast<mp_limb_t>(high >> 64);
    mpz_roinit_n(number_, limbs_, value.high < 0 ? -4 : 4);
  }
  explicit View(Int128 value) : View(Wide{static_cast<UInt128>(value), value < 0 ? -1 : 0}) {}
  View(const View&) = delete;
  View& operator=(const View&) = delete;
  operator mpz_srcptr() const { return number_; }

 private:
  mp_limb_t limbs_[4];
  mpz_t number_;
};

inline View view(Int128 value) { return View(value); }
inline View view(const Wide& value) { return View(value); }
inline mpz_srcptr view(const Integer& value) { return value.get_mpz_t(); }

template <class Value>
Rational rational(const Value& value) {
  Rational result;
  mpz_set(result.get_num_mpz_t(), view(value));
  return result;
}

template <class Value>
Rational absolute(const Value& value) {
  Rational result;
  mpz_abs(result.get_num_mpz_t(), view(value));
  return result;
}

/// numerator / denominator, canonical; the denominator is not zero.
Rational quotient(mpz_srcptr numerator, mpz_srcptr denominator);
template <class Numerator, class Denominator>
Rational quotient(const Numerator& numerator, const Denominator& denominator) {
  return quotient(static_cast<mpz_srcptr>(view(numerator)), static_cast<mpz_srcptr>(view(denominator)));
}

}  // namespace touchstone::oracle
