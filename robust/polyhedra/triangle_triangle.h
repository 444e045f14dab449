// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "geometry/triangles.h"
#include "robust/kernel/filters/face_filter.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The dimension of the intersection of two triangles in space: `none`, `point`, `segment` or `area`.
///
/// Edges and corners belong to them. A triangle without area is the segment or the point that its corners span. Right
/// for all finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names the
/// field and "finite number". Contract: reference/polyhedra/triangle_triangle.h.
inline TriangleTriangleRelation triangle_triangle(const Triangle3d& a, const Triangle3d& b);

namespace stages {

struct triangle_triangle : Filtered<triangle_triangle, decltype(robust::triangle_triangle)> {
  /// If all corners of one are certainly on one side of the other's plane there is no intersection. If each plane
  /// certainly has corners of the other triangle on both sides and none on itself, both triangles meet the line of the
  /// two planes in a segment, and two signs decide whether these overlap. Every sign is that of FacePlane.
  static Perhaps<TriangleTriangleRelation> filter(const Triangle3d& a, const Triangle3d& b);
  static Partial lattice;
  static Total exact;
  static Staged past_filter;
};

}  // namespace stages

inline TriangleTriangleRelation triangle_triangle(const Triangle3d& a, const Triangle3d& b) {
  return stages::triangle_triangle::ask(a, b).answer;
}

}  // namespace touchstone::robust
