// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "geometry/closest.h"
#include "geometry/triangles.h"

namespace touchstone::reference {

/// The fraction of a total that a number is.
struct ByQuotient {
  template <class Real>
  static std::array<Real, 2> parts(const Real& x, const Real& y, const Real& total) {
    return {Real(x / total), Real(y / total)};
  }
};

/// Selects the region in which p lies: of a corner, of an edge, or of the face.
template <class Real, class Division = ByQuotient>
Point3<Real> nearest_of_triangle(const Point3<Real>& p, const Triangle3<Real>& triangle) {
  const auto& [a, b, c] = triangle;
  const Vector3<Real> ab = b - a, ac = c - a;
  const Real zero(0), from_a = dot(ab, p - a), on_ac = dot(ac, p - a);
  if (from_a <= zero && on_ac <= zero) return a;
  const Real from_b = dot(ab, p - b), on_ac_of_b = dot(ac, p - b);
  if (from_b >= zero && on_ac_of_b <= from_b) return b;
  const Real of_c = Real(from_a * on_ac_of_b - from_b * on_ac);
  if (of_c <= zero && from_a >= zero && from_b <= zero) return a + Real(from_a / Real(from_a - from_b)) * ab;
  const Real from_c = dot(ab, p - c), on_ac_of_c = dot(ac, p - c);
  if (on_ac_of_c >= zero && from_c <= on_ac_of_c) return c;
  const Real of_b = Real(from_c * on_ac - from_a * on_ac_of_c);
  if (of_b <= zero && on_ac >= zero && on_ac_of_c <= zero) return a + Real(on_ac / Real(on_ac - on_ac_of_c)) * ac;
  const Real of_a = Real(from_b * on_ac_of_c - from_c * on_ac_of_b);
  const Real leaves_b = Real(on_ac_of_b - from_b), leaves_c = Real(from_c - on_ac_of_c);
  if (of_a <= zero && leaves_b >= zero && leaves_c >= zero)
    return b + Real(leaves_b / Real(leaves_b + leaves_c)) * (c - b);
  const auto [to_b, to_c] = Division::parts(of_b, of_c, Real(of_a + of_b + of_c));
  return a + (to_b * ab + to_c * ac);
}

/// The point of a closed triangle in space that is nearest to a point, its distance and the square of that.
///
/// No page of the deck asks this. The formula is the textbook's (Ericson, Real-Time Collision Detection, 5.1.5): the
/// scalar products of the edges from a with the displacements from the corners to p tell whether p lies beyond a
/// corner, whose point is the corner; then whether it lies beyond an edge, whose point divides it as in p. 9's
/// parametric form; and else the point has the weights of the three areas into which it divides the triangle. point,
/// triangle: any unit of length, the same for both; the squared distance is in its square. There is always exactly one
/// nearest point, because a triangle is closed and convex. A point of the triangle is its own, at distance
/// 0. Without area a triangle is the segment or the point that its corners span.
/// NaN or infinity: refused by robust and oracle (field "point[0]", "triangle[0][0]" ..., "finite number").
///
/// In exact arithmetic the formula is right, but where a == b and (c - a) . (p - a) > 0: there it takes p to be beyond
/// an edge of length 0, and divides 0 by 0 (cause: algorithm).
///
/// Rounding (binary64, to nearest, u = 2^-53): let P(v, w) be the sum of |v_k w_k| over the axes, exactly. The scalar
/// product of two computed differences is off by e(v, w) = (5 + 11u) u P(v, w) + 2^-1073, unless something overflows.
/// So where (b - a) . (p - a) and (c - a) . (p - a), exactly, are below -e, the answer is a, as in exact arithmetic.
/// Its squared distance is off by (5 + 11u) u of itself and 2^-1072 then. Nothing is promised of other regions: whether
/// p is beyond an edge is the sign of a difference of products. ulps: 66 roundings behind the distance (9 differences
/// of edges and 9 of displacements, six scalar products of five, three areas of three, a sum, two quotients, twelve in
/// the point, less what is shared; three differences, three squares, two sums, the root).
template <class Real>
ClosestPoint3<Real> closest_point_on_triangle(const Point3<Real>& point, const Triangle3<Real>& triangle) {
  using std::sqrt;
  const Point3<Real> x = nearest_of_triangle<Real>(point, triangle);
  const Real square = dot(point - x, point - x);
  return {x, square, Real(sqrt(square))};
}

}  // namespace touchstone::reference
