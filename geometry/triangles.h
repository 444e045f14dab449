// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/space.h"

/// Segments and triangles of space, and what operations answer about them.
namespace touchstone {

/// The closed set of points between a and b in space. a == b is valid: the single point a.
template <class Real>
struct Segment3 {
  Point3<Real> a, b;
  static constexpr auto members = as_list("a", "b");
};

/// The smallest convex set that holds three points of space, closed. Valid without area, too: a segment or a point.
template <class Real>
struct Triangle3 {
  Point3<Real> a, b, c;
  static constexpr auto members = as_list("a", "b", "c");
};

using Segment3d = Segment3<double>;
using Triangle3d = Triangle3<double>;

/// The dimension of the common part of two triangles.
enum class TriangleTriangleRelation { none, point, segment, area };
constexpr auto words_of(TriangleTriangleRelation) { return as_words("none", "point", "segment", "area"); }
constexpr auto plain_false(TriangleTriangleRelation) { return TriangleTriangleRelation::none; }

enum class SegmentTriangleRelation { none, point, segment };
constexpr auto words_of(SegmentTriangleRelation) { return as_words("none", "point", "segment"); }
constexpr auto plain_false(SegmentTriangleRelation) { return SegmentTriangleRelation::none; }

/// relation `point`: the one common point and its t on the segment, point = a + t (b - a) (0 on a segment of length
/// zero). `segment`: the common segment, its ends in the direction of the segment. `none`: no numbers.
template <class Real>
struct SegmentTriangle {
  SegmentTriangleRelation relation;
  std::optional<Real> t;
  std::optional<Point3<Real>> point;
  std::optional<Segment3<Real>> overlap;
  static constexpr auto members = as_record("relation", "t", "point", "overlap");
};

}  // namespace touchstone
