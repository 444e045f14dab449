// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/answers.h"
#include "geometry/volumes.h"

namespace touchstone::reference {

/// Finds when two balls that move along straight lines first have a common point, by the quadratic formula.
///
/// Deck p. 23, 51: at time t the centers are at center + t velocity. With p and v the position and the velocity of a
/// relative to b and r the sum of the radii, the balls meet where |p + t v| <= r, and |p + t v| = r is A t^2 + B t + C
/// = 0 with A = v . v, B = 2 p . v, C = p . p - r^2. They first touch at
///     t = (-B - sqrt(B^2 - 4 A C)) / (2 A);
/// `hit` where that is in [0, 1], otherwise `never`.
/// a, b: any unit of length, the same for both; velocities in that unit a step; t counts in steps. Closed sets:
/// touching is a hit. The truth is `hit` with t = 0 if the balls meet at the start, otherwise with the first t in [0,
/// 1] where they meet, which is that root; otherwise `never`. Radius 0 is a point; zero velocities are valid.
/// NaN or infinity: refused by robust and oracle (field, "finite number"); so is a negative radius ("a.radius",
/// "b.radius", "radius >= 0").
///
/// The formula assumes that the balls are apart and that one moves relative to the other. Where they overlap at the
/// start, or touch there and part, its root is negative: it answers `never`, or is 0/0 with equal velocities, in exact
/// arithmetic too (cause: algorithm). Equal velocities of balls that are apart are 0/0 or a root of a negative number,
/// and no comparison with NaN holds: `never`, which is right.
///
/// Rounding (binary64, to nearest, u = 2^-53), where A and Q = p . p + r^2 are in [2^-480, 2^480]; let M = A Q, so that
/// by Cauchy |B| <= 2 sqrt(M). Differences, products and sums make A off by 5u A, B by 10u sqrt(M), C by 6u Q (and
/// terms of u^2; what underflows is smaller than these). So B^2 is off by (2 * 2 * 10 + 4) u M, 4 A C by (4 * 6 + 4 * 5
/// + 4) u M, and their difference D, at most 8 M, by another 8u M for its rounding: by 100u M in all, and with the
/// terms of u^2 by less than e(D) = 104u M. Where D > e(D), s = sqrt(D) is off by at most e(D) / s and its rounding u
/// s, and -B - s by 11u sqrt(M), by that, and by its rounding; so, s being at most 3 sqrt(M), t is off by at most
///     e(t) = 7u sqrt(Q / A) + 53u Q / s + 9u |t| + 2^-1074.
/// `hit` is right, and t as good as that, where D > e(D) and e(t) < t < 1 - e(t). `never` is right where D < -e(D), and
/// where D > e(D) and either t > 1 + e(t), or t < -e(t) and C > 7u Q.
/// ulps: 30 roundings behind t (three in each of p and v, one in r; five in each of A and B, seven in C; three in D;
/// root, sum, quotient).
template <class Real>
FirstContact<Real> swept_sphere_sphere(const Sphere3<Real>& a, const Sphere3<Real>& b, const Vector3<Real>& velocity_a,
                                       const Vector3<Real>& velocity_b) {
  using std::sqrt;
  const Vector3<Real> p = a.center - b.center;
  const Vector3<Real> v{Real(velocity_a.x - velocity_b.x), Real(velocity_a.y - velocity_b.y),
                        Real(velocity_a.z - velocity_b.z)};
  const Real r = Real(a.radius + b.radius);
  const Real square = dot(v, v), linear = Real(Real(2) * dot(p, v)), constant = Real(dot(p, p) - Real(r * r));
  const Real discriminant = Real(Real(linear * linear) - Real(Real(Real(4) * square) * constant));
  if (discriminant < Real(0)) return {HitRelation::never, std::nullopt};
  const Real t = Real(Real(-linear - Real(sqrt(discriminant))) / Real(Real(2) * square));
  if (Real(0) <= t && t <= Real(1)) return {HitRelation::hit, t};
  return {HitRelation::never, std::nullopt};
}

}  // namespace touchstone::reference
