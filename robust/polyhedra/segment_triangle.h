// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "geometry/triangles.h"
#include "robust/kernel/filters/segments/segment_triangle_filter.h"
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
    /// it has two of them on different sides. One branch: the answer is unpredictable.
    static Perhaps<SegmentTriangleRelation> filter(const Segment3d& segment, const Triangle3d& triangle) {
      using filters::Sign;
      const filters::SegmentAndTriangle<double> both(segment, triangle);
      const Sign at_p = both.at_p(), at_q = both.at_q();
      const Sign ab = both.beside_ab(), bc = both.beside_bc(), ca = both.beside_ca();
      const auto any = [&](Sign sign) { return (ab == sign) | (bc == sign) | (ca == sign); };
      const int certain = (at_p != Sign::unknown) & (at_q != Sign::unknown), apart = at_p == at_q;
      const int outside = any(Sign::positive) & any(Sign::negative), unknown = any(Sign::unknown);
      if ((certain & (apart | outside | !unknown)) == 0) [[unlikely]]
        return std::nullopt;
      return (apart | outside) != 0 ? SegmentTriangleRelation::none : SegmentTriangleRelation::point;
    }
    /// The same by planes through three points, of which more signs are certain.
    static Perhaps<SegmentTriangleRelation> by_planes(const Segment3d& segment, const Triangle3d& triangle);
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
