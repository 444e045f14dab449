// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "reference/mixed/closest_point_on_triangle.h"
#include "reference/mixed/segment_segment_distance.h"
#include "reference/polyhedra/segment_triangle.h"

namespace touchstone::reference {

/// The square of the distance of a segment from a triangle: the least of an end from the triangle and of the segment
/// from an edge, beginning with that of an end from a corner.
template <class Real>
Real squared_distance_of(const Segment3<Real>& segment, const Triangle3<Real>& triangle) {
  if (segment_triangle<Real>(segment, triangle).relation != SegmentTriangleRelation::none) return Real(0);
  const auto& [p, q] = segment;
  const auto& [a, b, c] = triangle;
  Real least = dot(p - a, p - a);
  const auto try_next = [&least](const Point3<Real>& x, const Point3<Real>& y) {
    const Real square = dot(x - y, x - y);
    if (square < least) least = square;
  };
  try_next(p, nearest_of_triangle<Real>(p, triangle));
  try_next(q, nearest_of_triangle<Real>(q, triangle));
  for (const Segment3<Real>& edge : {Segment3<Real>{a, b}, Segment3<Real>{b, c}, Segment3<Real>{c, a}}) {
    const auto [x, y] = nearest_of_segments<Real>(p, q, edge.a, edge.b);
    try_next(x, y);
  }
  return least;
}

/// Decides whether a capsule and a closed triangle in space overlap, only touch, or neither.
///
/// No page of the deck asks this. The formula is the textbook's (Ericson, Real-Time Collision Detection, 5.1.10): where
/// the segment passes through the triangle, by p. 54, their distance is 0; otherwise it is the least of those of the
/// segment's ends from the triangle, as in closest_point_on_triangle, and of the segment from the edges, as in
/// segment_segment_distance. Its square is compared with that of the radius (p. 48-50); equal squares are `touching`.
/// capsule, triangle: any unit of length, the same for both. Shapes are closed. A triangle has no interior:
/// `overlapping` is answered where an interior point of the capsule is in the triangle, `touching` where they only
/// meet. A triangle without area is the segment or the point that its corners span. A radius of 0 (or -0) is valid:
/// such a capsule is a segment, which has no interior, and the truth is `touching` at most. A segment of length 0 is
/// valid: the capsule is a ball. NaN or infinity: refused by robust and oracle (field "capsule.segment[0][0]",
/// "triangle[0][0]" ..., "finite number"); so is a negative radius ("capsule.radius", "radius >= 0").
///
/// In exact arithmetic the formula is right where the triangle has an area: of an edge that is parallel to the segment
/// the distance is 0/0, which is less than no number, but another edge, or an end, is as near. Without area, a triangle
/// that is a point or parallel to the segment, or a segment of length 0, may have no other (cause: algorithm).
///
/// Rounding (binary64, to nearest, u = 2^-53), where the heights of both ends over the triangle's plane are certain and
/// of one sign, by the contract of segment_triangle, and the nearest point of the triangle to each end is certainly the
/// corner a, by that of closest_point_on_triangle: each point as computed is, on each axis, within 5u (|p| + |q|) +
/// 2^-1074 of a point of the segment, or of an edge, from p to q. Let e be 5u times the sum of the magnitudes of all
/// coordinates, and 6 times 2^-1074. As in capsule_capsule, where the distance D exceeds e + (1 + 8u) R + 2^-535, R
/// being the radius, the double version answers `disjoint`, and is right, unless something overflows. Otherwise nothing
/// is promised. No number is returned.
template <class Real>
Contact capsule_triangle(const Capsule3<Real>& capsule, const Triangle3<Real>& triangle) {
  const Real distance = squared_distance_of<Real>(capsule.segment, triangle), r = capsule.radius, reach = Real(r * r);
  return distance > reach ? Contact::disjoint : distance < reach ? Contact::overlapping : Contact::touching;
}

}  // namespace touchstone::reference
