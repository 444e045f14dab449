// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/triangles.h"
#include "robust/kernel/filters/sized.h"

/// Decides by certain signs which parts of points, segments and triangles hold their nearest points.
namespace touchstone::robust::filters {

/// A corner, the interior of an edge, or that of a triangle: `corners` of them, starting with `from`. 0: unknown.
struct Part {
  int corners = 0;
  std::array<Point3d, 3> at{};

  static Part corner(const Point3d& p) { return {1, {p, {}, {}}}; }
  static Part edge(const Point3d& p, const Point3d& q) { return {2, {p, q, {}}}; }
  static Part face(const Triangle3d& t) { return {3, {t.a, t.b, t.c}}; }
};

/// The only pair of nearest points; or, for parallel segments, the pair with the least parameter on a.
struct Parts {
  Part of_a, of_b;
  explicit operator bool() const { return of_a.corners != 0; }
};

/// All numbers are `moderate`.
///
/// The distance to a convex set has one least value, and a point attains it if no direction into the set leads nearer
/// (KKT): by the signs of scalar products with the edges from there. Every one is Sized.
Parts nearest_parts(const Segment3d& a, const Point3d& p);
Parts nearest_parts(const Triangle3d& a, const Point3d& p);
/// As a function of the parameters the squared distance is convex too. Each end of one segment is taken with the point
/// of the other that is nearest to it, and is the right one if the other's slope there leads no nearer. At the start of
/// a the slope may be zero: there is no smaller parameter. Otherwise it must be positive: then it is the only pair.
Parts nearest_parts(const Segment3d& a, const Segment3d& b);

}  // namespace touchstone::robust::filters
