// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "geometry/polygons.h"
#include "geometry/polyhedra.h"
#include "geometry/space.h"
#include "geometry/thin_shapes.h"
#include "geometry/volumes.h"
#include "geometry/words.h"

/// Answers of operations. A field that the enumerator next to it rules out is empty.
namespace touchstone {

/// relation `on`: point = a + t (b - a), 0 <= t <= 1; t is 0 on a segment of length zero. `off`: no t.
template <class Real>
struct PointOnSegment {
  Incidence relation;
  std::optional<Real> t;
  static constexpr auto members = as_record("relation", "t");
};

/// relation `crossing`: a.p + ta (a.q - a.p) = b.p + tb (b.q - b.p) = point. `parallel` (no common point) and `same`:
/// no numbers.
template <class Real>
struct LineLine {
  LineRelation relation;
  std::optional<Real> ta, tb;
  std::optional<Point2<Real>> point;
  static constexpr auto members = as_record("relation", "ta", "tb", "point");
};

/// relation `point`: the one common point, at ta on a and tb on b (0 on a segment of length zero).
/// `overlap`: the common segment, its ends in lexicographic order (x, then y). `disjoint`: no numbers.
template <class Real>
struct SegmentSegment {
  SegmentRelation relation;
  std::optional<Real> ta, tb;
  std::optional<Point2<Real>> point;
  std::optional<Segment2<Real>> overlap;
  static constexpr auto members = as_record("relation", "ta", "tb", "point", "overlap");
};

/// relation `point`: the one common point and its t on the ray. `overlap`: t of the first common point, and the common
/// segment, its ends in order of t. `none`: no numbers.
template <class Real>
struct RaySegment {
  RayRelation relation;
  std::optional<Real> t;
  std::optional<Point2<Real>> point;
  std::optional<Segment2<Real>> overlap;
  static constexpr auto members = as_record("relation", "t", "point", "overlap");
};

/// strict: convex, and no interior angle is flat. `not_simple` and `degenerate`: not strict, orientation `none`.
struct PolygonConvexity {
  PolygonClass polygon_class;
  bool strict;
  Winding orientation;
  static constexpr auto members = as_record("class", "strict", "orientation");
};

/// signed_distance: positive in front, 0 on the plane, in the unit of the coordinates.
template <class Real>
struct PointPlane {
  PlaneSide side;
  Real signed_distance;
  static constexpr auto members = as_record("side", "signed_distance");
};

/// `proper`: the normal by Newell's sum, and that vector divided by its length. `degenerate`: neither.
template <class Real>
struct PolygonNormal {
  NormalClass normal_class;
  std::optional<Vector3<Real>> normal, unit;
  static constexpr auto members = as_record("class", "normal", "unit");
};

/// Decides whether the end of a step is no longer in front of the plane.
struct StepTest {
  HitRelation relation;
  static constexpr auto members = as_record("relation");
};

/// relation `hit`: the first t in [0, 1], and the point start + t (end - start) there. `never`: no numbers.
template <class Real>
struct FirstHit {
  HitRelation relation;
  std::optional<Real> t;
  std::optional<Point3<Real>> point;
  static constexpr auto members = as_record("relation", "t", "point");
};

/// relation `hit`: the first t in [0, 1] at which two moving solids have a common point. `never`: no number.
template <class Real>
struct FirstContact {
  HitRelation relation;
  std::optional<Real> t;
  static constexpr auto members = as_record("relation", "t");
};

/// The convex hull of points in the plane, by their places in the list; of equal points, any one. dimension 0: `point`;
/// 1: `segment`, its ends; 2: `polygon`, the extreme points counter-clockwise. The other fields are empty.
struct ConvexHull2 {
  Index dimension;
  std::optional<Index> point;
  std::optional<IndexPair> segment;
  std::optional<std::vector<Index>> polygon;
  static constexpr auto members = as_record("dimension", "point", "segment", "polygon");
};

/// The convex hull of points in space, by their places in the list; of equal points, any one. dimension 0: `point`;
/// 1: `segment`, its ends; 2: `polygon`, the extreme points in order around it, in either direction; 3: `faces`,
/// triangles that are counter-clockwise as seen from outside. The other fields are empty.
struct ConvexHull {
  Index dimension;
  std::optional<Index> point;
  std::optional<IndexPair> segment;
  std::optional<std::vector<Index>> polygon;
  std::optional<std::vector<Face>> faces;
  static constexpr auto members = as_record("dimension", "point", "segment", "polygon", "faces");
};

template <class Real>
struct PointPlaneToi {
  StepTest option_1;
  FirstHit<Real> option_2;
  static constexpr auto members = as_record("option_1", "option_2");
};

}  // namespace touchstone
