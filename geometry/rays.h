// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/answers.h"
#include "geometry/triangles.h"

/// Rays of space, and what operations answer about rays and segments.
namespace touchstone {

/// The closed set origin + t direction, t >= 0, in space; t counts in lengths of the direction as given. A zero
/// direction is refused.
template <class Real>
struct Ray3 {
  Point3<Real> origin;
  Vector3<Real> direction;
  static constexpr auto members = as_record("origin", "direction");
  bool rules(const auto& check) const { return check("direction", rule::direction(direction)); }
};

using Ray3d = Ray3<double>;

/// The common part of a ray or a segment and a plane: `inside` is all of it.
enum class LinePlaneRelation { none, point, inside };
constexpr auto words_of(LinePlaneRelation) { return as_words("none", "point", "inside"); }
constexpr auto plain_false(LinePlaneRelation) { return LinePlaneRelation::none; }

/// relation `point`: the one common point and its t: origin + t direction of a ray, a + t (b - a) of a segment. `none`
/// and `inside`: no numbers.
template <class Real>
struct LinePlane {
  LinePlaneRelation relation;
  std::optional<Real> t;
  std::optional<Point3<Real>> point;
  static constexpr auto members = as_record("relation", "t", "point");
};

/// The common part of a ray and a triangle. relation `point`: the one common point, its t, and its place in the
/// triangle: `inside`, or on its `boundary`, which is all of a triangle without area. `segment`: the first common point
/// and its t. `none`: no numbers.
template <class Real>
struct RayTriangle {
  SegmentTriangleRelation relation;
  std::optional<Real> t;
  std::optional<Point3<Real>> point;
  std::optional<Location> location;
  static constexpr auto members = as_record("relation", "t", "point", "location");
};

/// Decides whether a ray or a segment meets a solid.
enum class PassageRelation { none, hit };
constexpr auto words_of(PassageRelation) { return as_words("none", "hit"); }
constexpr auto plain_false(PassageRelation) { return PassageRelation::none; }

/// relation `hit`: the first and the last t of a common point; both are 0 on a segment of length zero. `none`: no
/// numbers.
template <class Real>
struct Passage {
  PassageRelation relation;
  std::optional<Real> first, last;
  static constexpr auto members = as_record("relation", "first", "last");
};

}  // namespace touchstone
