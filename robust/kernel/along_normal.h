// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/enclosed_shapes.h"
#include "robust/kernel/integers.h"
#include "robust/kernel/rounding.h"
#include "robust/kernel/staged.h"

/// Velocities that change along a normal: v + t n, t = c (d . n) / (m n . n), with d a velocity or a difference of two,
/// c and m made of masses and factors. The unit of the normal cancels.
///
/// Enclosed with one bound for all of it, instead of one for each step (enclosed.h, whose u, T and E these are): let S
/// be the sum of the sizes of the three products in d . n, s = |c| S and i the inverse of m n . n. In units of E s i:
/// - d . n is off by 18 as Sum has it, (high, low) with |low| <= 2.2 T S. As a factor it is off by 3.2 + 1.1 more, for
///   what is taken from high and added to low rounds by u of its result, settled or not. c as a factor: 2. c, where it
///   is itself a product: 11. The product of both: 1 + 1.1 + 2.2 + 1.1. Together 41, and its tail is below 2.2 T s.
/// - n . n is off by 18 of itself, its product with m by 12 more, the sum of its head and tail by 1: together 31.
/// - Of the quotient, head q: q times the divisor's head is exact, so its subtraction rounds by u of what is left, 4 T
///   s at most; by q times the tail and its subtraction 6 more, by adding low 3: 13. What is left then, 1.1 T s, times
///   the inverse, which is off by 2 u: 4.
/// - t n: q times the tail of n, and what is left times n, are off by 3, their sum by 3, adding it to what two_sum
///   leaves by 3 and u^2 |v|, and the ends of the enclosure round by 4 and u^2 |v| more: 13, and E |v| is plenty.
/// Together 102; 144 are taken, eight times the error of Sum, |c| and i. A bound relative to S holds where the products
/// cancel, too: nothing here has to be settled. Not proved by machine.
namespace touchstone::robust::kernel {

/// Two scalar products, lane by lane.
inline Enclosed<Two> enclosed_dots(const Vector3<Factor<Two>>& v, const Vector3<Factor<Two>>& w) {
  Sum sum(product(v.x, w.x));
  sum += product(v.y, w.y), sum += product(v.z, w.z);
  return sum.value();
}

/// v . n and n . n.
inline Enclosed<Two> approach_and_square(const Vector3d& v, const Vector3d& n) {
  return enclosed_dots(factors(Two(v.x, n.x), Two(v.y, n.y), Two(v.z, n.z)), factors(n));
}

/// t = head + tail, so near that head * n + tail * n is within error |n| + E |v| of t n where it is added to v.
template <class Float>
struct Share {
  Float head, tail, error;
};

/// numerator / d; size: |c| times the error of d . n.
template <class Float>
[[gnu::always_inline]] inline Share<Float> share(const Term2<Float>& numerator, const Float& size,
                                                 const Factor<Float>& d, const Float& inverse) {
  using Format = filters::FloatFormat<Float>;
  const Float q = Format::head((numerator.head + numerator.tail) * inverse);
  const Float rest = ((numerator.head - q * d.head) - q * d.tail) + numerator.tail;
  return {q, rest * inverse, Format::above(8) * size * inverse};
}

/// v + t n, as `along` of enclosed.h, but that the error holds for the ends of the enclosure as they are rounded, too.
template <class Float>
[[gnu::always_inline]] inline Enclosed<Float> along(const Float& v, const Share<Float>& t, const Factor<Float>& n) {
  using Format = filters::FloatFormat<Float>;
  const Pair<Float> sum = two_sum(t.head * n.head, v);
  const Float low = sum.low + (t.head * n.tail + t.tail * n.whole);
  const Float margin = t.error * Format::magnitude(n.whole) + Format::above(cut<Float>) * Format::magnitude(v);
  return {sum.high, low, margin};
}

/// The same, rounded.
template <class Float>
[[gnu::always_inline]] inline std::optional<Float> enclosed_push(const Float& v, const Share<Float>& t,
                                                                 const Factor<Float>& n) {
  const Enclosed<Float> x = along(v, t, n);
  const Float above = x.high + (x.low + x.error), below = x.high + (x.low - x.error);
  if (!(above <= below)) return std::nullopt;
  return above + Float();  // -0 + 0 is +0
}

inline Perhaps<Vector3d> enclosed_push(const Vector3d& v, const Share<double>& t, const Vector3d& n) {
  const Share<Two> of_both{Two(t.head), Two(t.tail), Two(t.error)};
  const auto xy = enclosed_push(Two(v.x, v.y), of_both, factor(Two(n.x, n.y)));
  if (!xy) return std::nullopt;
  const auto z = enclosed_push(v.z, t, factor(n.z));
  if (!z) return std::nullopt;
  return {std::in_place, xy->first(), xy->second(), *z};
}

/// Numbers of a vector as integers on one power of two.
inline Vector3<mpz_class> whole_vector(const Integers<3>& numbers) {
  return {numbers.at[0], numbers.at[1], numbers.at[2]};
}
inline Integers<3> integers_of(const Vector3d& v) { return integers_of(v.x, v.y, v.z); }

/// v + (a / b) n times 2^exponent, rounded.
inline Vector3d pushed(const Vector3<mpz_class>& v, const mpz_class& a, const mpz_class& b, const Vector3<mpz_class>& n,
                       long exponent) {
  const auto component = [&](const mpz_class& from, const mpz_class& step) {
    return round_quotient(mpz_class(b * from + a * step), b, exponent);
  };
  return {component(v.x, n.x), component(v.y, n.y), component(v.z, n.z)};
}

}  // namespace touchstone::robust::kernel
