// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/triangles.h"

namespace touchstone::reference {

/// Finds the intersection of a closed segment and a closed triangle in space.
///
/// Deck p. 54: the ends of the edge lie on opposite sides of the face's plane; intersect the two; the point is inside
/// the face. With the normal N = (b - a) x (c - a) of the triangle, the segment from p to q and E(x) = N . (x - a):
/// `none` where E(p) and E(q) have one sign; otherwise
///     t = E(p) / (E(p) - E(q)),  x = p + t (q - p),
/// and `point` where ((b - a) x (x - a)) . N and the same of the edges b, c and c, a are all >= 0; otherwise `none`.
/// segment, triangle: any unit of length, the same for both; t: a pure number, 0 at the segment's a and 1 at its b.
/// Closed sets: ends, edges and corners belong to them, so a touch is a `point`. `segment`: a common segment, its ends
/// in the segment's direction. Degenerate: a segment of length 0 is a point, its t is 0; a triangle without area is the
/// segment or the point that its corners span. NaN or infinity: refused by robust and oracle (field, "finite number").
///
/// The slide has no case for a segment in the triangle's plane, for a triangle without area and for a segment of
/// length 0: all of these are `none` even in exact arithmetic (cause: algorithm), and `segment` is never answered. In
/// exact arithmetic it is right about all others: x is a point of the plane.
///
/// Rounding (binary64, to nearest, u = 2^-53): let P be the sum of the magnitudes of the six products of three
/// differences in an E, taken exactly. A product goes through three differences, two products, a difference and two
/// sums, so E as computed is off by at most e(E) = ((1 + u)^8 - 1) P < 8 (1 + 4u) u P; where products underflow, by
/// 2^-1073 (|x| + |y| + |z| + 2) more, with p - a = (x, y, z); unless something overflows. Where E(p) and E(q) exceed
/// that and have one sign, the double version is right with `none`. Where they have different ones, t, of which T is
/// the computed one, is off by at most (e(E(p)) + e(E(q))) / (|E(p)| + |E(q)|) + 3 u T + 2^-1073, with E as computed:
/// numerator and denominator are off by e(E(p)) and e(E(p)) + e(E(q)), the exact quotient is between 0 and 1, and the
/// denominator's sum and the quotient are two roundings. Nothing is promised of the decision inside or outside of an
/// edge. ulps: 33 roundings behind t (twelve differences, twelve products, three differences of the normal, four sums,
/// a difference, a quotient), 36 behind each coordinate of the point.
template <class Real>
SegmentTriangle<Real> segment_triangle(const Segment3<Real>& segment, const Triangle3<Real>& triangle) {
  const SegmentTriangle<Real> none{SegmentTriangleRelation::none, std::nullopt, std::nullopt, std::nullopt};
  const auto& [a, b, c] = triangle;
  const Vector3<Real> normal = cross(b - a, c - a);
  const Real at_p = dot(normal, segment.a - a), at_q = dot(normal, segment.b - a), difference = at_p - at_q;
  const bool in_front = at_p > Real(0) && at_q > Real(0), behind = at_p < Real(0) && at_q < Real(0);
  if (in_front || behind || difference == Real(0)) return none;
  const Real t = at_p / difference;
  const Point3<Real> x = segment.a + t * (segment.b - segment.a);
  const auto within = [&](const Point3<Real>& from, const Point3<Real>& to) {
    return dot(cross(to - from, x - from), normal) >= Real(0);
  };
  if (!within(a, b) || !within(b, c) || !within(c, a)) return none;
  return {SegmentTriangleRelation::point, t, x, std::nullopt};
}

}  // namespace touchstone::reference
