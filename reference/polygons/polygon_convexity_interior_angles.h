// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/answers.h"
#include "geometry/validation.h"

namespace touchstone::reference {

/// The angle at every vertex on the left of the ring, from the next edge counter-clockwise to the one before, in [0, 2
/// pi].
///
/// acos of the dot product over the product of the lengths; where the cross product is negative the vertex is reflex
/// and the angle is what is left of 2 pi. The product of the lengths is written as one root, so that flat and right
/// angles are exact wherever arithmetic is. pi is acos(-1).
template <class Real>
std::vector<Real> angles_on_the_left(const Polygon2<Real>& given) {
  const validation::OpenRing open(given);
  const Polygon2<Real>& polygon = *open;
  using std::acos, std::sqrt;
  const Real pi = acos(Real(-1));
  std::vector<Real> angles;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2<Real> v = polygon.next(i) - polygon[i], w = polygon.previous(i) - polygon[i];
    const Real lengths = sqrt(Real(dot(v, v) * dot(w, w)));
    const Real angle = acos(Real(dot(v, w) / lengths));
    angles.push_back(cross(v, w) < Real(0) ? Real(Real(2) * pi - angle) : angle);
  }
  return angles;
}

template <class Real>
Real sum_of(const std::vector<Real>& angles) {
  Real sum(0);
  for (const Real& angle : angles) sum = sum + angle;
  return sum;
}

/// Decides whether a ring of vertices bounds a convex region, by its interior angles. The question is that of
/// polygon_convexity.h.
///
/// Deck p. 6: convex where no interior angle exceeds pi. The angles are acos of a dot product, and the sign of the
/// cross product tells which of them are reflex; the interior angles of a simple polygon add up to (n - 2) pi. That sum
/// tells all that the slide does not: the angles on the left add up to (n - 2) pi where the left is the inside (ccw),
/// to (n + 2) pi where it is the outside (cw), and to another (n - 2k) pi where the ring turns k times; so what is
/// nearest to neither is `not_simple`. strict: no angle of exactly pi.
///
/// Nothing in it sees a ring that crosses itself and turns once, nor a spike (an angle of 0 or 2 pi as good as any),
/// nor a common line (cause: algorithm). At repeated neighbours the quotient is 0 / 0, and nothing compares with its
/// angle.
///
/// Rounding (binary64, to nearest, u = 2^-53): without overflow and underflow (all differences 0 or between 2^-200 and
/// 2^200 in magnitude) the computed quotient is off by at most 11u: the dot product by 4u |v| |w|, the root by a factor
/// of 1 + 5.5u, the quotient by one more rounding, and 0.5u is left for terms of u^2; the cross product is off by less
/// than 5u |v| |w|. So where the sine of every angle exceeds 2^-20 in magnitude, each acos is off by less than 12u 2^20
/// and the library's error, flat and reflex angles are distinguished, and for simple rings of fewer than 2^20 vertices
/// the sum is nearest to the right multiple of pi: the answer is right.
template <class Real>
PolygonConvexity polygon_convexity_interior_angles(const Polygon2<Real>& polygon) {
  using std::acos;
  const std::vector<Real> angles = angles_on_the_left(polygon);
  const Real pi = acos(Real(-1)), n = Real(static_cast<int>(angles.size()));
  bool smaller = false, flat = false, larger = false;
  for (const Real& angle : angles) {
    smaller = smaller || angle < pi;
    flat = flat || angle == pi;
    larger = larger || angle > pi;
  }
  const Real sum = sum_of(angles);
  const auto nearest_to = [&](const Real& multiple) {
    return sum > Real(Real(multiple - Real(1)) * pi) && sum < Real(Real(multiple + Real(1)) * pi);
  };
  const auto answer = [&](bool reflex, Winding winding) -> PolygonConvexity {
    return {reflex ? PolygonClass::concave : PolygonClass::convex, !reflex && !flat, winding};
  };
  if (nearest_to(Real(n - Real(2)))) return answer(larger, Winding::ccw);
  if (nearest_to(Real(n + Real(2)))) return answer(smaller, Winding::cw);
  return {PolygonClass::not_simple, false, Winding::none};
}

}  // namespace touchstone::reference
