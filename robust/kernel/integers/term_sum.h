// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/integers/integers.h"

/// Exact sums of doubles and of products of two doubles, whose exponents may lie anywhere.
namespace touchstone::robust::kernel {

/// (negative ? -1 : 1) * magnitude * 2^exponent, magnitude odd and below 2^106, or zero.
struct Term {
  UInt128 magnitude;
  int exponent;
  bool negative;
  friend Term operator-(const Term& t) { return {t.magnitude, t.exponent, !t.negative}; }
};

inline Term term(double value) {
  const Decoded part = decode(value);
  const int zeros = std::countr_zero(part.magnitude | std::uint64_t{1} << 63);
  return {part.magnitude >> zeros, part.exponent + zeros, part.negative};
}

/// a * b
inline Term term(double a, double b) {
  const Term left = term(a), right = term(b);
  return {left.magnitude * right.magnitude, left.exponent + right.exponent, left.negative != right.negative};
}

/// n * 2^exponent
template <class Integer>
struct Scaled {
  Integer n;
  int exponent;
};

inline int bit_width(UInt128 n) {
  const auto high = static_cast<std::uint64_t>(n >> 64);
  return high != 0 ? 128 - std::countl_zero(high) : 64 - std::countl_zero(static_cast<std::uint64_t>(n));
}

/// The position of the lowest set bit of any term (0 if all are zero), and one past the highest.
template <std::size_t N>
Scaled<int> span_of(const std::array<Term, N>& terms) {
  int low = INT_MAX, high = INT_MIN;
  for (const Term& t : terms)
    if (t.magnitude != 0) {
      low = std::min(low, t.exponent);
      high = std::max(high, t.exponent + bit_width(t.magnitude));
    }
  return low == INT_MAX ? Scaled<int>{0, 0} : Scaled<int>{high, low};
}

/// The exact sum, empty if the terms span more than 124 binary digits (four such terms fit 126).
template <std::size_t N>
std::optional<Scaled<Int128>> lattice_sum(const std::array<Term, N>& terms) {
  static_assert(N <= 4);
  const auto [high, low] = span_of(terms);
  if (high - low > 124) return std::nullopt;
  Scaled<Int128> sum{0, low};
  for (const Term& t : terms) {
    if (t.magnitude == 0) continue;
    const auto size = static_cast<Int128>(t.magnitude << (t.exponent - low));
    sum.n += t.negative ? -size : size;
  }
  return sum;
}

mpz_class scaled(const Term& t, int shift);

/// The same number as a GMP integer.
mpz_class integer_of(Int128 n);

/// The exact sum.
template <std::size_t N>
Scaled<mpz_class> exact_sum(const std::array<Term, N>& terms) {
  const int low = span_of(terms).exponent;
  Scaled<mpz_class> sum{0, low};
  for (const Term& t : terms)
    if (t.magnitude != 0) sum.n += scaled(t, t.exponent - low);
  return sum;
}

}  // namespace touchstone::robust::kernel
