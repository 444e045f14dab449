// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/closest.h"
#include "geometry/thin_shapes.h"
#include "geometry/triangles.h"

namespace touchstone::reference {

template <class Real>
Real in_unit_interval(const Real& t) {
  return t < Real(0) ? Real(0) : t > Real(1) ? Real(1) : t;
}

/// Two points, one of each segment.
template <class Point>
struct NearestEnds {
  Point on_a, on_b;
};

/// The foot of the common perpendicular on the line of a, moved into a; the point of b's line that is nearest to that,
/// moved into b; and if it was moved, the point of a that is nearest to it.
template <class Real, class Point>
NearestEnds<Point> nearest_of_segments(const Point& a0, const Point& a1, const Point& b0, const Point& b1) {
  const auto v = a1 - a0, w = b1 - b0, r = a0 - b0;
  const Real vv = dot(v, v), ww = dot(w, w), vw = dot(v, w), vr = dot(v, r), wr = dot(w, r);
  Real s = in_unit_interval<Real>(Real(Real(vw * wr - vr * ww) / Real(vv * ww - vw * vw)));
  Real t = Real(Real(vw * s + wr) / ww);
  if (t < Real(0)) t = Real(0), s = in_unit_interval<Real>(Real(-vr / vv));
  else if (t > Real(1)) t = Real(1), s = in_unit_interval<Real>(Real(Real(vw - vr) / vv));
  return {a0 + s * v, b0 + t * w};
}

/// A pair of nearest points of two closed segments, their distance and its square. In the plane and in space.
///
/// No page of the deck asks this. The formula is the textbook's (Ericson, Real-Time Collision Detection, 5.1.9), put
/// together from p. 12-13's parameters on two lines and p. 48-50's way to move what lies outside of an interval to its
/// end: the parameters of the common perpendicular's feet, each moved into [0, 1] in its turn.
/// a, b: any unit of length, the same for both; the squared distance is in its square. Shapes are closed: segments that
/// cross or touch have the distance 0, and both points are the common one.
/// Where many pairs are as near, because the segments are parallel, the pair with the least parameter on a is the
/// answer: the point of a that is nearest to a.a. There is only one such pair. Engines may name another that is as
/// near, unless they declare that they name this one (`nearest`, docs/engines.md).
/// A segment of length 0 is valid: it is a point.
/// NaN or infinity: refused by robust and oracle (field "a[0][0]", "b[1][2]" ..., "finite number").
///
/// The formula divides by the square of the cross product of both directions: where segments are parallel, or of length
/// 0, that is 0/0, or another number by 0, in exact arithmetic too (cause: algorithm). In exact arithmetic it is right
/// about all others.
///
/// Rounding (binary64, to nearest, u = 2^-53), where nothing overflows and no number is NaN: each point as computed is,
/// on each axis, within 3u |v| + u |X| + 2^-1074 of a point of its segment, X being its coordinate and v the segment's
/// extent; let e be the sum of these over both points and all axes. So the distance D is never too short by more: D >=
/// (D* - e) (1 - 4u) - 2^-536, D* being the exact distance. There is no bound on how much too long it may be: for
/// segments that are nearly parallel both parameters are lost. ulps: 51 roundings behind the distance in space (nine
/// differences, five scalar products of five, three and one in s, three in t, four in each coordinate, less what is
/// shared; three differences, three squares, two sums, the root).
template <class Real>
ClosestPair2<Real> segment_segment_distance(const Segment2<Real>& a, const Segment2<Real>& b) {
  using std::sqrt;
  const auto [x, y] = nearest_of_segments<Real>(a.a, a.b, b.a, b.b);
  const Real square = dot(x - y, x - y);
  return {x, y, square, Real(sqrt(square))};
}
template <class Real>
ClosestPair3<Real> segment_segment_distance(const Segment3<Real>& a, const Segment3<Real>& b) {
  using std::sqrt;
  const auto [x, y] = nearest_of_segments<Real>(a.a, a.b, b.a, b.b);
  const Real square = dot(x - y, x - y);
  return {x, y, square, Real(sqrt(square))};
}

}  // namespace touchstone::reference
