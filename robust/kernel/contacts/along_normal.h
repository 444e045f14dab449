// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "robust/kernel/enclosed/enclosed_shapes.h"
#include "robust/kernel/enclosed/push.h"
#include "robust/kernel/filters/staged.h"
#include "robust/kernel/integers/integers.h"
#include "robust/kernel/integers/rounding.h"

/// Velocities that change along a normal: v + t n, t = c (d . n) / (m n . n), with d a velocity or a difference of two,
/// c and m made of masses and factors. The unit of the normal cancels.
///
/// Enclosed with one bound for all of it, instead of one for each step (enclosed.h, whose u, T and E these are): let S
/// be the sum of the sizes of the three products in d . n, s = |c| S and i the inverse of m n . n. In units of E s i:
/// - d . n is off by 18 as Sum has it, (high, low) with |low| <= 2.2 T S. As a factor it is off by 3.2 + 1.1 more, for
///   what is taken from high and added to low rounds by u of its result, settled or not. c as a factor: 2. c, where it
///   is itself a product: 11. The product of both: 1 + 1.1 + 2.2 + 1.1. Together 41, and its tail is below 2.2 T s.
/// - n . n is off by 18 of itself, its product with m by 12 more, the sum of its head and tail by 1: together 31.
/// - The quotient has the head q: q times the divisor's head is exact, so its subtraction rounds by u of what is left,
///   4 T
///   s at most; by q times the tail and its subtraction 6 more, by adding low 3: 13. The remainder, 1.1 T s, times the
///   inverse, which is off by 2 u: 4.
/// - t n: 14.6, as robust/kernel/enclosed/push.h has it of a tail below 2.4 T s i.
/// Together 104; 144 are taken, eight times the error of Sum, |c| and i. A bound relative to S holds where the products
/// cancel, too: nothing here has to be settled. Not proved by machine, except for the last line.
namespace touchstone::robust::kernel {

/// Two scalar products, one per lane.
inline Enclosed<Two> enclosed_dots(const Vector3<Factor<Two>>& v, const Vector3<Factor<Two>>& w) {
  Sum sum(product(v.x, w.x));
  sum += product(v.y, w.y), sum += product(v.z, w.z);
  return sum.value();
}

/// v . n and n . n.
inline Enclosed<Two> approach_and_square(const Vector3d& v, const Vector3d& n) {
  return enclosed_dots(factors(Two(v.x, n.x), Two(v.y, n.y), Two(v.z, n.z)), factors(n));
}

/// Returns numerator / d; size: |c| times the error of d . n.
template <class Float>
[[gnu::always_inline]] inline Share<Float> share(const Term2<Float>& numerator, const Float& size,
                                                 const Factor<Float>& d, const Float& inverse) {
  using Format = filters::FloatFormat<Float>;
  const Float q = Format::head((numerator.head + numerator.tail) * inverse);
  const Float rest = ((numerator.head - q * d.head) - q * d.tail) + numerator.tail;
  return {q, rest * inverse, Format::above(8) * size * inverse};
}

/// A vector whose parts are not yet combined: constructed in place, see Perhaps.
struct Pushed {
  Two xy, z;

  Vector3d answer() const { return {xy.first(), xy.second(), z.first()}; }
};

/// t is the same in both lanes.
[[gnu::always_inline]] inline std::optional<Pushed> enclosed_push(const Vector3d& v, const Share<Two>& t,
                                                                  const Vector3d& n) {
  const auto xy = enclosed_push(Two(v.x, v.y), t, factor(Two(n.x, n.y)));
  if (!xy) return std::nullopt;
  const auto z = enclosed_push(Two(v.z), t, factor(Two(n.z)));
  if (!z) return std::nullopt;
  return Pushed{*xy, *z};
}

/// The numbers of a vector as integers over one power of two.
inline Vector3<mpz_class> integer_vector(const Integers<3>& numbers) {
  return {numbers.at[0], numbers.at[1], numbers.at[2]};
}
inline Integers<3> integers_of(const Vector3d& v) { return integers_of(v.x, v.y, v.z); }

/// v + (a / b) n times 2^exponent, rounded.
inline Vector3d pushed(const Vector3<mpz_class>& v, const mpz_class& a, const mpz_class& b, const Vector3<mpz_class>& n,
                       std::int64_t exponent) {
  const auto component = [&](const mpz_class& from, const mpz_class& step) {
    return round_quotient(mpz_class(b * from + a * step), b, exponent);
  };
  return {component(v.x, n.x), component(v.y, n.y), component(v.z, n.z)};
}

}  // namespace touchstone::robust::kernel
