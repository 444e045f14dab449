// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/points.h"
#include "geometry/rules.h"

namespace touchstone {

/// The closed set of points between a and b. a == b is valid: the single point a.
template <class Real>
struct Segment2 {
  Point2<Real> a, b;
  static constexpr auto members = as_list("a", "b");
};

/// The line through two points. p == q is refused: it has no direction.
template <class Real>
struct Line2 {
  Point2<Real> p, q;
  static constexpr auto members = as_list("p", "q");
  bool rules(const auto& check) const { return check("", {!validation::same_position(p, q), "two distinct points"}); }
};

/// The line origin + t direction. A zero direction is refused.
template <class Real>
struct ParametricLine2 {
  Point2<Real> origin;
  Vector2<Real> direction;
  static constexpr auto members = as_record("origin", "direction");
  bool rules(const auto& check) const { return check("direction", rule::direction(direction)); }
};

/// The closed set origin + t direction, t >= 0; t counts in lengths of the direction as given. A zero direction is
/// refused.
template <class Real>
struct Ray2 {
  Point2<Real> origin;
  Vector2<Real> direction;
  static constexpr auto members = as_record("origin", "direction");
  bool rules(const auto& check) const { return check("direction", rule::direction(direction)); }
};

/// The circle |p - center| = radius; as a solid, the closed disc. Radius 0 is valid (a point); a negative radius is
/// refused.
template <class Real>
struct Circle2 {
  Point2<Real> center;
  Real radius;
  static constexpr auto members = as_record("center", "radius").of(Meaning::length);
  bool rules(const auto& check) const { return check("radius", rule::radius(radius)); }
};

using Segment2d = Segment2<double>;
using Line2d = Line2<double>;
using ParametricLine2d = ParametricLine2<double>;
using Ray2d = Ray2<double>;
using Circle2d = Circle2<double>;

}  // namespace touchstone
