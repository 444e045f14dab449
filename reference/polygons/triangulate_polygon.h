// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <numeric>

#include "geometry/answers.h"
#include "geometry/validation.h"

namespace touchstone::reference {

/// Cuts a simple polygon of n vertices into n - 2 triangles whose corners are its vertices: counter-clockwise triples
/// of indices.
///
/// Deck p. 7: ear clipping. A vertex is an ear if its angle is convex, E > 0 for
///     E = (y - y0)(x1 - x0) - (x - x0)(y1 - y0)
/// of its two neighbours and itself, and no other vertex that is left lies in the triangle of the three, boundary
/// included (all three E >= 0). Ears are cut off until three vertices are left. A ring whose area sum (x_i y_i+1 -
/// x_i+1 y_i) / 2 is negative is gone through backwards.
///
/// polygon: simple, in either direction; any unit of length. Many answers are right: every triangle has positive area,
/// the interiors of no two meet, and together they are the polygon. Degenerate: a flat vertex is a corner of some
/// triangle like every other, and no triangle has area 0; a simple polygon always has such a triangulation:
/// (1) If there are four or more vertices, two can be joined inside. The vertex v that comes first by x, then y turns
/// left; u, w
///     are its neighbours. If the closed triangle uvw holds no other vertex, uw is a diagonal. Otherwise let z be one
///     of
///     those held that is farthest from the line uw on v's side: the part of the triangle beyond z holds no vertex,
///     hence no piece of an edge (it could leave through uv or vw only), so vz is a diagonal.
/// (2) A diagonal makes two smaller rings, both simple; so by induction n - 3 diagonals make n - 2 triangles, each a
///     simple ring of three vertices, of positive area.
/// (3) Their diagonals connect them in a tree. One with a single neighbour has two edges of the ring as sides,
///     and no vertex in it but its corners: its middle corner is an ear. There are two of these, their middle corners
///     no neighbours.
/// A last position that repeats the first is no vertex; it is dropped, once, and all indices are those of the ring as
/// given. Refused: NaN or infinity (field, "finite number"), fewer than three vertices (field, "at least 3 vertices"),
/// a ring that is not simple (the first vertex of the offending edge, and the rule; of a position twice in a row
/// "different from vertex i: drop one of the two").
///
/// Rounding (binary64, to nearest, u = 2^-53): each computed E is off by at most (3 + 16u) u (|L| + |R|) + 2^-1073, L
/// and R its two products as computed (see orientation), and the area's sum of n terms by (n + 1) u / (1 - (n + 1) u) S
/// + n 2^-1073, S the sum of the sizes of its 2n products, unless something overflows. Where the sum and every E of
/// three of the vertices exceed their bounds, every decision is right, and so is the answer. Otherwise it may find no
/// ear and stop with fewer triangles, or cut off what is none. In exact arithmetic the formula is always right, because
/// an ear always exists.
template <class Real>
std::vector<std::vector<Index>> triangulate_polygon(const Polygon2<Real>& given) {
  const validation::OpenRing open(given);
  const Polygon2<Real>& polygon = *open;
  std::vector<Index> left(polygon.size());
  std::iota(left.begin(), left.end(), Index{0});
  Real area = Real(0);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2<Real>&p = polygon[i], &q = polygon.next(i);
    area = Real(area + Real(Real(p.x * q.y) - Real(q.x * p.y)));
  }
  if (area < Real(0)) std::reverse(left.begin(), left.end());

  const auto e = [&](Index i, Index j, Index k) {
    const Point2<Real>&p0 = polygon[i], &p1 = polygon[j], &p = polygon[k];
    return Real(Real((p.y - p0.y) * (p1.x - p0.x)) - Real((p.x - p0.x) * (p1.y - p0.y)));
  };
  const auto is_ear = [&](Index a, Index b, Index c) {
    if (!(e(a, b, c) > Real(0))) return false;
    return std::none_of(left.begin(), left.end(), [&](Index p) {
      return p != a && p != b && p != c && e(a, b, p) >= Real(0) && e(b, c, p) >= Real(0) && e(c, a, p) >= Real(0);
    });
  };

  std::vector<std::vector<Index>> triangles;
  while (left.size() > 3) {
    const std::size_t n = left.size();
    std::size_t i = 0;
    while (i < n && !is_ear(left[(i + n - 1) % n], left[i], left[(i + 1) % n])) ++i;
    if (i == n) return triangles;
    triangles.push_back({left[(i + n - 1) % n], left[i], left[(i + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
  }
  triangles.push_back(left);
  return triangles;
}

}  // namespace touchstone::reference
