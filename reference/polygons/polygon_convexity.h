// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/validation.h"

namespace touchstone::reference {

/// Decides whether a ring of vertices bounds a convex region, by the line test.
///
/// Deck p. 5: convex where for every edge all other vertices lie on one side of the line through that edge, by the sign
/// for the edge a -> b of
///     E = (y - ay)(bx - ax) - (x - ax)(by - ay);
/// concave where some edge has vertices on both sides. polygon: at least 3 vertices, any unit of length; the last is
/// joined to the first; either direction. Decided in this order: `degenerate`: two neighbours are the same point, or
/// all vertices lie on one line (area 0 alone is not enough: a figure eight has it too). `not_simple`: two edges meet
/// at a point other than the vertex that neighbours share; a spike, where the ring turns back on itself, is one.
/// `convex`: every vertex is on one closed side of every edge's line. `concave`: the rest. strict: convex, and no three
/// neighbours on a line. orientation: `ccw` where the inside lies left of the edges (y up), otherwise `cw`;
/// `not_simple` and `degenerate` have `none` and are not strict. NaN or infinity: refused by robust and oracle
/// (polygon[i][k], "finite number"); so are fewer than 3 vertices (polygon, "at least 3 vertices"). A last position
/// that repeats the first is no vertex: it is dropped, once, before all this.
///
/// The slide knows of convex and concave alone. The other parts of the answer follow from the same signs where
/// possible: a convex ring is ccw if vertices lie left of its edges, and strict if none lies on their lines. For a
/// concave one, which has no such side, twice its area is summed over the triangles from vertex 0. Nothing in it sees
/// repeated neighbours, a common line or edges that cross: degenerate rings come out convex, crossing ones concave, or
/// convex where they go round twice (cause: algorithm). For simple rings of some area the formula is right in exact
/// arithmetic.
///
/// Rounding (binary64, to nearest, u = 2^-53): with L and R the two products of E as computed, E is off by at most (3 +
/// 16u) u (|L| + |R|) + 2^-1073 unless something overflows (reference/lines/orientation.h). The class and strictness
/// are right for a simple ring where every |E| exceeds that. The sum of n - 2 triangles is off by at most (n + 2) u
/// times the sum of all |L| + |R| in it, and n 2^-1073, because each product has three roundings before it and at most
/// n - 2 after it; beyond that the orientation of a concave ring is right, and that of a convex one always is where its
/// class is.
template <class Real>
PolygonConvexity polygon_convexity(const Polygon2<Real>& given) {
  const validation::OpenRing open(given);
  const Polygon2<Real>& polygon = *open;
  const std::size_t n = polygon.size();
  bool convex = true, strict = true, ccw = false, cw = false;
  for (std::size_t i = 0; i < n; ++i) {
    const Point2<Real>&a = polygon[i], &b = polygon.next(i);
    bool left = false, right = false;
    for (std::size_t k = 2; k < n; ++k) {
      const Point2<Real>& p = polygon[(i + k) % n];
      const Real e = Real((p.y - a.y) * (b.x - a.x)) - Real((p.x - a.x) * (b.y - a.y));
      left = left || e > Real(0);
      right = right || e < Real(0);
      strict = strict && e != Real(0);
    }
    convex = convex && !(left && right);
    ccw = ccw || left, cw = cw || right;
  }
  if (convex) return {PolygonClass::convex, strict, ccw ? Winding::ccw : cw ? Winding::cw : Winding::none};
  Real area(0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Vector2<Real> v = polygon[i] - polygon[0], w = polygon[i + 1] - polygon[0];
    area = area + Real(Real(v.x * w.y) - Real(v.y * w.x));
  }
  return {PolygonClass::concave, false, area > Real(0) ? Winding::ccw : area < Real(0) ? Winding::cw : Winding::none};
}

}  // namespace touchstone::reference
