// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/closest.h"
#include "geometry/triangles.h"
#include "reference/polyhedra/point_mesh_distance.h"

namespace touchstone::reference {

/// The point of a triangle that is nearest to p.
template <class Real, class Division = ByQuotient>
Point3<Real> nearest_of_triangle(const Point3<Real>& p, const Triangle3<Real>& triangle) {
  return nearest_place_in_triangle<Real, Division>(p, triangle).point;
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
