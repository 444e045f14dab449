// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"

namespace touchstone::reference {

/// Decides whether a point lies on a closed segment, by the slide's two parameters tx and ty.
///
/// Deck p. 10-11:
///     tx = (x - ax) / (bx - ax),  ty = (y - ay) / (by - ay);
/// on where tx = ty and 0 <= tx <= 1, otherwise off. point, segment: any unit of length, the same for both. Closed set:
/// both ends are on. Returns t = tx where on. Degenerate: a segment of length 0 is the point a, and t is 0 on it.
/// NaN or infinity: refused by robust and oracle (field, "finite number").
///
/// The formula divides by each extent of the segment. On a segment parallel to an axis or of length 0 one or both of
/// the quotients are x / 0, so it answers `off` for every point of it, even in exact arithmetic (cause: algorithm).
///
/// Rounding (binary64, to nearest, u = 2^-53): with T the computed quotient, its two differences and the division are
/// off by a factor of at most (1 + u)^2 / (1 - u) <= 1 + (3 + 5u) u, and 2^-1074 covers a quotient that underflows. So
/// each of tx, ty is off by at most e(T) = (3 + 5u) u |T| + 2^-1074, unless a difference or a quotient overflows. The
/// double version is rightly `off` when |tx - ty| exceeds e(tx) + e(ty), and when tx is below 0 or above 1 by more than
/// e(tx). On the segment itself the margin is 0 and nothing is promised: any rounding in tx that ty does not share
/// makes it `off`. ulps: 3 roundings behind t (two differences, one quotient).
template <class Real>
PointOnSegment<Real> point_on_segment(const Point2<Real>& point, const Segment2<Real>& segment) {
  const Vector2<Real> to_point = point - segment.a, to_end = segment.b - segment.a;
  const Real tx = Real(to_point.x / to_end.x), ty = Real(to_point.y / to_end.y);
  if (tx == ty && Real(0) <= tx && tx <= Real(1)) return {Incidence::on, tx};
  return {Incidence::off, std::nullopt};
}

}  // namespace touchstone::reference
