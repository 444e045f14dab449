// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/points.h"
#include "geometry/rules.h"

namespace touchstone {

/// A place in a list, counted from 0.
using Index = std::uint32_t;

/// A closed ring of at least three vertices in the plane, in either direction; the last is joined to the first. Fewer
/// are refused. A last position that repeats the first is no vertex: operations drop it, once (geometry/rules.h).
template <class Real>
struct Polygon2 {
  std::vector<Point2<Real>> vertices;
  static constexpr auto members = as_bare("vertices");
  bool rules(const auto& check) const { return check("", rule::ring(vertices)); }
  std::size_t size() const { return vertices.size(); }
  const Point2<Real>& operator[](std::size_t i) const { return vertices[i]; }
  /// The vertex after vertex i, and before it, round the ring.
  const Point2<Real>& next(std::size_t i) const { return vertices[i + 1 == vertices.size() ? 0 : i + 1]; }
  const Point2<Real>& previous(std::size_t i) const { return vertices[i == 0 ? vertices.size() - 1 : i - 1]; }
};

using Polygon2d = Polygon2<double>;

/// A region of the plane: the closed polygon of the outer ring without the open insides of the holes. Which rings fit
/// together takes exact arithmetic (HoleDefect in geometry/validation.h).
template <class Real>
struct Region2 {
  Polygon2<Real> outer;
  std::vector<Polygon2<Real>> holes;
  static constexpr auto members = as_record("outer", "holes");
};

using Region2d = Region2<double>;

}  // namespace touchstone
