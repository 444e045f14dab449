// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/points.h"
#include "geometry/space.h"

/// Answers about nearest points.
namespace touchstone {

/// The point of a shape that is nearest to another point, and their distance.
template <class Real>
struct ClosestPoint2 {
  Point2<Real> point;
  Real squared_distance, distance;
  static constexpr auto members = as_record("point", "squared_distance", "distance");
};
template <class Real>
struct ClosestPoint3 {
  Point3<Real> point;
  Real squared_distance, distance;
  static constexpr auto members = as_record("point", "squared_distance", "distance");
};

/// A point of each of two shapes, as near to each other as any, and their distance.
template <class Real>
struct ClosestPair2 {
  Point2<Real> on_a, on_b;
  Real squared_distance, distance;
  static constexpr auto members = as_record("on_a", "on_b", "squared_distance", "distance");
};
template <class Real>
struct ClosestPair3 {
  Point3<Real> on_a, on_b;
  Real squared_distance, distance;
  static constexpr auto members = as_record("on_a", "on_b", "squared_distance", "distance");
};

enum class ConvexRelation { apart, meeting };
constexpr auto words_of(ConvexRelation) { return as_words("apart", "meeting"); }
constexpr auto plain_false(ConvexRelation) { return ConvexRelation::apart; }

/// relation `apart`: a point of each of two convex shapes, as near to each other as any. `meeting`: no points; both
/// numbers are 0.
template <class Real>
struct ConvexDistance {
  ConvexRelation relation;
  std::optional<Point3<Real>> on_a, on_b;
  Real squared_distance, distance;
  static constexpr auto members = as_record("relation", "on_a", "on_b", "squared_distance", "distance");
};

}  // namespace touchstone
