// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "geometry/triangles.h"
#include "robust/kernel/filters/face_filter.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Finds the intersection of a segment and a triangle in space: `none`; `point`, with its t on the segment; or
/// `segment`, the common part, its ends in the direction of the segment.
///
/// Ends, edges and corners belong to them. A segment of length 0 is a point (t is 0), a triangle without area the
/// segment or the point that its corners span. Right for all finite doubles in every floating-point environment, and
/// every number correctly rounded. NaN and infinities throw InvalidInput, which names the field and "finite number".
/// Contract: reference/polyhedra/segment_triangle.h.
SegmentTriangle<double> segment_triangle(const Segment3d& segment, const Triangle3d& triangle);

/// The decision alone, which costs less.
inline SegmentTriangleRelation segment_triangle_relation(const Segment3d& segment, const Triangle3d& triangle);

namespace stages {

struct segment_triangle : Signatures<decltype(robust::segment_triangle)> {
  static Partial enclosed;
  static Total exact;

  struct decision : Filtered<decision, decltype(robust::segment_triangle_relation)> {
    /// Decides if both ends are certainly not on the triangle's plane. On one side of it there is no intersection. On
    /// two sides the line crosses the plane once, inside the triangle if it has all three edges on one side, outside if
    /// it has two of them on different sides. Every sign is that of FacePlane.
    static Perhaps<SegmentTriangleRelation> filter(const Segment3d& segment, const Triangle3d& triangle) {
      using filters::Sign;
      using Plane = filters::FacePlane<double>;
      const auto& [p, q] = segment;
      const auto& [a, b, c] = triangle;
      const Plane plane(a, b, c);
      const Sign at_p = plane.side(p), at_q = plane.side(q);
      if (at_p == Sign::unknown || at_q == Sign::unknown) return std::nullopt;
      if (at_p == at_q) return SegmentTriangleRelation::none;
      const Sign ab = Plane(p, q, a).side(b), bc = Plane(p, q, b).side(c), ca = Plane(p, q, c).side(a);
      const auto any = [&](Sign sign) { return ab == sign || bc == sign || ca == sign; };
      if (any(Sign::positive) && any(Sign::negative)) return SegmentTriangleRelation::none;
      if (any(Sign::unknown)) return std::nullopt;
      return SegmentTriangleRelation::point;
    }
    static Partial lattice;
    static Total exact;
    static Staged past_filter;
  };
};

}  // namespace stages

inline SegmentTriangleRelation segment_triangle_relation(const Segment3d& segment, const Triangle3d& triangle) {
  return stages::segment_triangle::decision::ask(segment, triangle).answer;
}

}  // namespace touchstone::robust
