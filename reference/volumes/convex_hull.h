// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <utility>

#include "reference/volumes/convex_hull_2d.h"

namespace touchstone::reference {

/// The convex hull of points in space: triangles over its extreme points, by their indices in the list,
/// counter-clockwise as seen from outside.
///
/// Deck p. 35-42, gift wrapping, steps 1 to 5 of p. 35:
/// 1. Find the highest point (y is up; of several the first).
/// 2. Find the point that makes the smallest angle with the horizontal plane through it. The two make an edge.
/// 3. Lay a plane through this edge and the horizontal line across it.
/// 4. Find the point whose triangle with the edge makes the smallest angle with that plane. This is the first
///    triangle; its edges are unmatched.
/// 5. For each unmatched edge, find the point whose triangle with it makes the smallest angle with the plane of the
///    edge's own triangle. Its other edges are unmatched, unless they match one of those.
/// The angle of two planes is that of their normals, and angles are compared by their cosines (convex_hull_2d.h). The
/// slide does not say which of several points at one angle it is: the first in the list. Where two triangles have an
/// edge in one direction, or after twice as many triangles as there are points, it is given up. Two triangles back to
/// back are a polygon.
///
/// points: at least one, any unit of length. The answer has dimension 0 (all points are equal: `point`), 1 (they lie
/// on one line: `segment`, its ends in either order), 2 (in one plane: `polygon`, the extreme points in order around
/// it, in either direction) or 3 (`faces`). A vertex is an extreme point: one that lies on no segment between two
/// others. Points inside edges and faces are none, and of equal points one alone is listed. A flat face of more than
/// three corners may be cut into triangles in any way, without further corners; and any of equal points is right.
/// Refused by robust and oracle: NaN or infinity (points[i][k], "finite number"), an empty list (points, "at least 1
/// point").
///
/// Rounding (binary64, to nearest, u = 2^-53): all differences of coordinates shall be 0 or between 2^-100 and 2^100 in
/// magnitude, and s >= 2^-20 the least sine of an angle between the directions from one point to two others. A
/// coordinate of a normal v x w is off by at most 4u (|v_i w_j| + |v_j w_i|), so the normal by less than 6u |v| |w| <=
/// 6u |v x w| / s (that of step 3, without differences, by 4u). It moves a cosine by as much as its length is off in
/// units of itself, two normals by 12u / s, and the square by 24u / s. After the normals the dot product and
/// its square lose 7u, the squared lengths and their product 7u, the quotient u. With terms of u^2 the computed value
/// is off by less than 40u / s. So the answer is right where one point is the highest and where the values of no two
/// points that any step may compare are closer than 80u / s: those of step 2; those of triangles with one edge as seen
/// from one plane, that of step 3 or through the edge and a third point. Four points in a plane are beyond that promise
/// even where a wrong choice of a cut is none: they may be cut in two ways at once, and three on a line or two equal
/// ones may be walked through (cause: algorithm). Otherwise it is right in exact arithmetic.
template <class Real>
ConvexHull convex_hull(const std::vector<Point3<Real>>& points) {
  const auto count = static_cast<Index>(points.size());
  // The first point except a and b with the greatest value, unless that is undefined everywhere.
  const auto first_of_greatest = [count](Index a, Index b, const auto& value) {
    Index greatest = count;
    Real most(-2);
    for (Index i = 0; i < count; ++i) {
      if (i == a || i == b) continue;
      const Real here = value(i);
      if (here > most) greatest = i, most = here;
    }
    return greatest;
  };
  const auto normal = [&](Index a, Index b, Index c) { return cross(points[b] - points[a], points[c] - points[a]); };
  const auto across = [&](Index a, Index b, const Vector3<Real>& plane) {
    return first_of_greatest(a, b, [&](Index i) { return squared_cosine<Real>(plane, normal(a, b, i)); });
  };

  Index a = 0;
  for (Index i = 1; i < count; ++i) {
    if (points[i].y > points[a].y) a = i;
  }
  const Index b = first_of_greatest(a, a, [&](Index i) {
    const Vector3<Real> v = points[i] - points[a];
    return Real(Real(Real(v.x * v.x) + Real(v.z * v.z)) / dot(v, v));
  });
  if (b == count) return {0, a, {}, {}, {}};
  const Vector3<Real> e = points[b] - points[a], horizontal{e.z, Real(0), Real(-e.x)};
  const Index c = across(a, b, cross(e, horizontal));
  if (c == count) return {1, {}, IndexPair{a, b}, {}, {}};

  std::vector<Face> faces{{a, b, c}};
  std::set<std::pair<Index, Index>> edges{{a, b}, {b, c}, {c, a}};
  bool lost = false;
  for (std::size_t next = 0; next < faces.size() && faces.size() <= 2 * points.size() && !lost; ++next) {
    const Face f = faces[next];
    for (const auto& [from, to] : {std::pair{f.a, f.b}, {f.b, f.c}, {f.c, f.a}}) {
      if (edges.count({to, from}) != 0) continue;
      const Index i = across(to, from, normal(f.a, f.b, f.c));
      if (i == count) continue;
      faces.push_back({to, from, i});
      for (const auto& edge : {std::pair{to, from}, {from, i}, {i, to}}) lost = !edges.insert(edge).second || lost;
    }
  }
  if (faces.size() == 2) return {2, {}, {}, std::vector{a, b, c}, {}};
  return {3, {}, {}, {}, faces};
}

}  // namespace touchstone::reference
