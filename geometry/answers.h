// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/thin_shapes.h"

/// What operations answer. An enumerator is a word of the contract; a field that the enumerator rules out is empty.
namespace touchstone {

/// Where a point lies of a directed line p0 -> p1: `left` is counter-clockwise (y up).
enum class Side { left, on, right };

/// Where a point lies of a line that is not vertical; above is +y.
enum class Height { above, on, below };

/// Where a point lies of a solid: its interior, its boundary, or neither.
enum class Location { inside, boundary, outside };

/// Whether a point lies on a thin closed shape.
enum class Incidence { on, off };

enum class LineRelation { crossing, parallel, same };
enum class SegmentRelation { disjoint, point, overlap };
enum class RayRelation { none, point, overlap };

/// relation `on`: point = a + t (b - a), 0 <= t <= 1; t is 0 on a segment of length zero. `off`: no t.
template <class Real>
struct PointOnSegment {
  Incidence relation;
  std::optional<Real> t;
};

/// relation `crossing`: a.p + ta (a.q - a.p) = b.p + tb (b.q - b.p) = point. `parallel` (no common point) and `same`: no numbers.
template <class Real>
struct LineLine {
  LineRelation relation;
  std::optional<Real> ta, tb;
  std::optional<Point2<Real>> point;
};

/// relation `point`: the one common point, at ta on a and tb on b (0 on a segment of length zero).
/// `overlap`: the common segment, its ends in lexicographic order (x, then y). `disjoint`: no numbers.
template <class Real>
struct SegmentSegment {
  SegmentRelation relation;
  std::optional<Real> ta, tb;
  std::optional<Point2<Real>> point;
  std::optional<Segment2<Real>> overlap;
};

/// relation `point`: the one common point and its t on the ray. `overlap`: t of the first common point, and the common
/// segment, its ends in order of t. `none`: no numbers.
template <class Real>
struct RaySegment {
  RayRelation relation;
  std::optional<Real> t;
  std::optional<Point2<Real>> point;
  std::optional<Segment2<Real>> overlap;
};

}  // namespace touchstone
