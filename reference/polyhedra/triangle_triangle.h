// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/triangles.h"
#include "reference/polyhedra/segment_triangle.h"

namespace touchstone::reference {

/// The dimension of the intersection of two closed triangles in space.
///
/// Deck p. 54: the edges of each face against the other face, by the formula of reference/polyhedra/segment_triangle.h:
/// `none` where no edge meets the other triangle, `point` where all points that are found are equal, otherwise
/// `segment`.
/// a, b: any unit of length, the same for both. Closed sets: edges and corners belong to them. `area`: a common part
/// with an area. The points of the common part are not answered: that of an area is a polygon of up to six corners, for
/// which the deck has no formula. Degenerate: a triangle without area is the segment or the point that its corners
/// span. NaN or infinity: refused by robust and oracle (field, "finite number").
///
/// The slide has no case for what lies in one plane: triangles that overlap in an area, share an edge or touch in one
/// plane are decided by the edges that leave it, if any do, and `area` is never answered (cause: algorithm). So are
/// triangles without area.
///
/// Rounding (binary64, to nearest, u = 2^-53): with E and e(E) of reference/polyhedra/segment_triangle.h, the double
/// version is right with `none` where E for a exceeds e(E) at all corners of b, with one sign, and E for b at all
/// corners of a. Nothing is promised otherwise.
template <class Real>
TriangleTriangleRelation triangle_triangle(const Triangle3<Real>& a, const Triangle3<Real>& b) {
  std::optional<Point3<Real>> first;
  bool several = false;
  const auto edges_against = [&](const Triangle3<Real>& t, const Triangle3<Real>& other) {
    for (const Segment3<Real>& edge : {Segment3<Real>{t.a, t.b}, Segment3<Real>{t.b, t.c}, Segment3<Real>{t.c, t.a}}) {
      const SegmentTriangle<Real> met = segment_triangle(edge, other);
      if (!met.point) continue;
      several = several || (first && !(*first == *met.point));
      first = met.point;
    }
  };
  edges_against(a, b), edges_against(b, a);
  return several ? TriangleTriangleRelation::segment
         : first ? TriangleTriangleRelation::point
                 : TriangleTriangleRelation::none;
}

}  // namespace touchstone::reference
