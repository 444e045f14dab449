// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"

namespace touchstone::reference {

/// Finds where two lines cross, each given by two points.
///
/// Deck p. 12: P_a(ta) = P_b(tb), two equations in ta and tb. With A = a.q - a.p, B = b.q - b.p, W = b.p - a.p and the
/// cross product v.x w.y - v.y w.x, Cramer's rule gives
///     D = A x B,  ta = (W x B) / D,  tb = (W x A) / D;
/// `crossing` with the point a.p + ta A, or `parallel` where D = 0. a, b: any unit of length, the same for both; ta,
/// tb: pure numbers, in units of the lengths of A and of B. Lines are unbounded, so there is nothing open or closed
/// about them. NaN or infinity: refused by robust and oracle (field, "finite number"); so is a line with p == q ("two
/// distinct points").
///
/// The slide does not ask whether the parallel lines are one and the same, so `same` is never answered: coincident
/// lines are `parallel` even in exact arithmetic (cause: algorithm).
///
/// Rounding (binary64, to nearest, u = 2^-53): a cross product N = L - R of differences, L and R its products as
/// computed, carries three roundings in each product, which is ((1 + u)^3 - 1) <= (3 + 4u) u relatively, and (1 + u)^2
/// 2^-1075 where it underflows; the subtraction adds u |N| and keeps the sign. So
///     d(N) = (3 + 4u) u (|L| + |R|) + 2^-1073 bounds the error before the subtraction, e(N) = d(N) + u |N| after it.
/// The double version rightly answers `crossing` when |D| exceeds d(D), unless something overflows; where the lines are
/// parallel nothing is promised. With Q = N / D the exact quotient of the computed N and D, and T the computed one,
///     e(T) = (e(N) + |Q| e(D)) / (|D| - e(D)) + u |T| + 2^-1075   bounds the error of ta and tb while |D| > e(D), and
///     (1 + u) |A.x| e(ta) + (2 + 2u) u |P| + u |X| + 2^-1074      that of the point's x, with P = ta A.x and X = a.p.x
///     + P.
/// ulps: 13 roundings behind ta and tb (six differences, four products, two subtractions, one quotient), 15 behind each
/// coordinate of the point (a product and a sum more).
template <class Real>
LineLine<Real> line_line(const Line2<Real>& a, const Line2<Real>& b) {
  const Vector2<Real> da = a.q - a.p, db = b.q - b.p, w = b.p - a.p;
  const Real den = cross(da, db);
  if (den == Real(0)) return {LineRelation::parallel, std::nullopt, std::nullopt, std::nullopt};
  const Real ta = Real(cross(w, db) / den), tb = Real(cross(w, da) / den);
  return {LineRelation::crossing, ta, tb, a.p + ta * da};
}

}  // namespace touchstone::reference
