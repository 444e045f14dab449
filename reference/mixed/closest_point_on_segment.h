// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/closest.h"
#include "geometry/thin_shapes.h"
#include "geometry/triangles.h"

namespace touchstone::reference {

/// a + t (b - a), with the t of the foot of the perpendicular from p, moved into [0, 1].
template <class Real, class Point>
Point nearest_between(const Point& p, const Point& a, const Point& b) {
  const auto v = b - a;
  const Real t = Real(dot(p - a, v) / dot(v, v));
  return a + (t < Real(0) ? Real(0) : t > Real(1) ? Real(1) : t) * v;
}

/// The point of a closed segment that is nearest to a point, its distance and the square of that. In the plane and in
/// space.
///
/// No page of the deck asks this. The formula combines two: p. 9's line in parametric form, of which the foot of the
/// perpendicular has
///     t = (p - a) . (b - a) / ((b - a) . (b - a));
/// and p. 48-50's way to the nearest point of a box, by which t is moved to 0 or 1 if it lies outside of [0, 1].
/// point, segment: any unit of length, the same for both; the squared distance is in its square. There is always
/// exactly one nearest point, because a segment is closed and convex. A point of the segment is its own, at distance 0.
/// a == b is valid: such a segment is a point, and the nearest. The formula divides by the squared length: there it is
/// 0/0, in exact arithmetic too (cause: algorithm). In exact arithmetic it is right about all other segments.
/// NaN or infinity: refused by robust and oracle (field "point[0]", "segment[0][0]" ..., "finite number").
///
/// Rounding (binary64, to nearest, u = 2^-53), where (b - a) . (b - a) as computed is at least 2^-960 and nothing
/// overflows. Let L be that square, exactly, and P the sum of |(p - a)_k (b - a)_k| over the axes. A scalar product
/// carries five roundings at most: (p - a) . (b - a) is off by (5 + 11u) u P + 2^-1073, and L by (5 + 12u) u L. Moving
/// both quotients into [0, 1] takes them no further apart, and leaves of the relative errors no more than themselves:
/// T, as computed, is off by e(T) = ((5 + 11u) u P + 2^-1073) / L + 7u. So each coordinate X of the answer is off by
/// e(X) = (e(T) (1 + 3u) + 3u) |b - a| + u |X| + 2^-1074 on its axis. Let e be the sum of these. The distance D from
/// the point as computed is off by less than 4u of itself and 2^-536, so D is off by at most e + 4u (D* + e) + 2^-536,
/// D* being the exact distance, and its square by 2 D* e + e^2 + 6u (D* + e)^2 + 2^-1072. ulps: 32 roundings behind the
/// distance in space (17 behind T, two more in each coordinate, three differences, three squares, two sums, the root).
template <class Real>
ClosestPoint2<Real> closest_point_on_segment(const Point2<Real>& point, const Segment2<Real>& segment) {
  using std::sqrt;
  const Point2<Real> x = nearest_between<Real>(point, segment.a, segment.b);
  const Real square = dot(point - x, point - x);
  return {x, square, Real(sqrt(square))};
}
template <class Real>
ClosestPoint3<Real> closest_point_on_segment(const Point3<Real>& point, const Segment3<Real>& segment) {
  using std::sqrt;
  const Point3<Real> x = nearest_between<Real>(point, segment.a, segment.b);
  const Real square = dot(point - x, point - x);
  return {x, square, Real(sqrt(square))};
}

}  // namespace touchstone::reference
