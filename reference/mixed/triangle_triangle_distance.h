// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/closest.h"
#include "reference/mixed/closest_point_on_triangle.h"
#include "reference/mixed/segment_segment_distance.h"
#include "reference/polyhedra/triangle_triangle.h"

namespace touchstone::reference {

/// The nearest of fifteen pairs: each corner with the other triangle's nearest point, and the nearest points of each
/// edge and each of the other's; beginning with the first corners.
template <class Real>
NearestEnds<Point3<Real>> nearest_of_triangles(const Triangle3<Real>& a, const Triangle3<Real>& b) {
  NearestEnds<Point3<Real>> nearest{a.a, b.a};
  const auto try_next = [&nearest](const Point3<Real>& x, const Point3<Real>& y) {
    const auto least = nearest.on_a - nearest.on_b, found = x - y;
    if (Real(dot(found, found)) < Real(dot(least, least))) nearest = {x, y};
  };
  for (const Point3<Real>& p : {a.a, a.b, a.c}) try_next(p, nearest_of_triangle<Real>(p, b));
  for (const Point3<Real>& q : {b.a, b.b, b.c}) try_next(nearest_of_triangle<Real>(q, a), q);
  for (const auto& [p0, p1] : {Segment3<Real>{a.a, a.b}, Segment3<Real>{a.b, a.c}, Segment3<Real>{a.c, a.a}}) {
    for (const auto& [q0, q1] : {Segment3<Real>{b.a, b.b}, Segment3<Real>{b.b, b.c}, Segment3<Real>{b.c, b.a}}) {
      const auto [x, y] = nearest_of_segments<Real>(p0, p1, q0, q1);
      try_next(x, y);
    }
  }
  return nearest;
}

/// Decides whether two closed triangles in space have a common point, and if not, points of both that are as near to
/// each other as any, and how far that is: the distance and its square.
///
/// No page of the deck asks this. The formula is the one that engines use (Larsen, Gottschalk, Lin and Manocha, Fast
/// proximity queries with swept sphere volumes, 1999, whose PQP calls it TriDist; Ericson, Real-Time Collision
/// Detection, 5.1.10): where an edge of one meets the other, by p. 54, they meet; otherwise the nearest points are
/// those of a corner and a triangle, as in closest_point_on_triangle, or of two edges, as in segment_segment_distance
/// (p. 12-13, 48-50). a, b: any unit of length, the same for both; the squared distance is in its square. Closed sets:
/// where they have a common point, touching included, the relation is `meeting`, both distances are 0 and no points are
/// given. Where many pairs are as near, because faces or edges are parallel, the points on a of all of them are a
/// convex set, and the one that is nearest to a's first corner is the answer, with the point of b that is as near to it
/// as any. There is only one such pair. Engines may name another that is as near, unless they declare that they name
/// this one (`nearest`, docs/engines.md). A triangle without area is valid: it is the segment or the point that its
/// corners span. Where they are apart by less than half of the least double, the distance is rounded to 0. NaN or
/// infinity: refused by robust and oracle (field "a[0][0]", "b[2][1]" ..., "finite number").
///
/// In exact arithmetic relation and distance are right where both triangles have an area: edges that are parallel give
/// 0/0, which is less than no number, but a corner of one of them is as near. Without area, the other formulas may
/// divide 0 by 0 where no other pair is as near. Among several nearest pairs it returns any (cause: algorithm).
///
/// Margin: where they are apart, the squared distance; where they meet, the square of the least length by which one has
/// to be moved until they only touch. That is 0 where they touch, and where all corners are in one plane.
///
/// Rounding (binary64, to nearest, u = 2^-53), where nothing overflows and no number is NaN: the distance D is at most
/// (1 + 4u) |a.a - b.a| + 2^-536, because that pair is tried first. Where both points are corners, it is not too short
/// by more either: D >= (1 - 4u) D* - 2^-536, D* being the exact distance. Nothing is promised of other points: see
/// closest_point_on_triangle and segment_segment_distance. ulps: 66 roundings behind the distance, those of
/// closest_point_on_triangle; segment_segment_distance has fewer.
template <class Real>
ConvexDistance<Real> triangle_triangle_distance(const Triangle3<Real>& a, const Triangle3<Real>& b) {
  using std::sqrt;
  const auto [x, y] = nearest_of_triangles<Real>(a, b);
  const Real square = dot(x - y, x - y);
  if (square == Real(0) || triangle_triangle<Real>(a, b) != TriangleTriangleRelation::none)
    return {ConvexRelation::meeting, {}, {}, Real(0), Real(0)};
  return {ConvexRelation::apart, x, y, square, Real(sqrt(square))};
}

}  // namespace touchstone::reference
