// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <utility>

#include "robust/kernel/integers/term_sum.h"

/// Doubles and their sums, differences and products, exact for all exponents: closed formulas are written as they
/// stand, with the vector operations of geometry/space.h.
namespace touchstone::robust::kernel {

using Dyadic = Scaled<mpz_class>;

inline Dyadic dyadic(double value) {
  const Integers<1> integers = integers_of(value);
  return {integers.at[0], integers.exponent};
}
template <template <class> class Vector>
Vector<Dyadic> dyadic(const Vector<double>& v) {
  return {dyadic(v.x), dyadic(v.y), dyadic(v.z)};
}

inline Dyadic operator-(const Dyadic& a) { return {-a.n, a.exponent}; }
inline Dyadic operator*(const Dyadic& a, const Dyadic& b) { return {a.n * b.n, a.exponent + b.exponent}; }
inline Dyadic operator+(const Dyadic& a, const Dyadic& b) {
  if (sgn(a.n) == 0) return b;
  if (sgn(b.n) == 0) return a;
  if (a.exponent < b.exponent) return b + a;
  mpz_class sum = a.n << static_cast<std::uint64_t>(a.exponent - b.exponent);
  sum += b.n;
  return {std::move(sum), b.exponent};
}
inline Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }

}  // namespace touchstone::robust::kernel
