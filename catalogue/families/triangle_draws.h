// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "catalogue/families/long_draws.h"
#include "catalogue/families/space_draws.h"
#include "geometry/triangles.h"

/// Points, segments and triangles of space in exact positions, drawn from a draw stream.
namespace touchstone::catalogue {

/// p + i v, exactly, for numbers of few digits.
inline Point3d along(const Point3d& p, double i, const Vector3d& v) { return p + i * v; }

/// A lattice plane, through a point and along two vectors, which may be parallel.
struct LatticePlane {
  Point3d origin;
  Vector3d u, v;

  static LatticePlane of(DrawStream& draws, int bits = 12) {
    return {lattice_point_in_space(draws, bits), lattice_normal(draws, bits), lattice_normal(draws, bits)};
  }
  Point3d at(double i, double j) const { return along(along(origin, i, u), j, v); }
  /// A few steps from the origin.
  Point3d point(DrawStream& draws, int most = 3) const {
    const double i = small_integer(draws, most);
    return at(i, small_integer(draws, most));
  }
  /// A few steps from the origin along u.
  Point3d on_line(DrawStream& draws, int most = 3) const { return at(small_integer(draws, most), 0); }
  Triangle3d triangle(DrawStream& draws) const { return {point(draws), point(draws), point(draws)}; }
  Triangle3d triangle_without_area(DrawStream& draws) const { return {on_line(draws), on_line(draws), on_line(draws)}; }
};

/// The corners are drawn by point(draws).
template <class Draw>
Triangle3d triangle_of(DrawStream& draws, const Draw& point) {
  return {point(draws), point(draws), point(draws)};
}

/// As long as 2^least to 2^most, a few units wide, around its middle.
inline Triangle3d needle(DrawStream& draws, int least, int most) {
  const double length = power_of_two(draws, least, most);
  const auto unit = [&draws] { return small_integer(draws, 3); };
  return {{-length, unit(), unit()}, {length, unit(), 0}, {length, 0, unit()}};
}

/// A point of the plane of the triangle, as far as doubles can tell.
inline Point3d rounded_onto(const Triangle3d& t, DrawStream& draws) {
  const double i = ordinary(draws), j = ordinary(draws);
  return t.a + (i * (t.b - t.a) + j * (t.c - t.a));
}

/// -1, 0 or 1, or 2^1023 times that: differences overflow, and products of what does not.
inline double huge_or_small(DrawStream& draws) {
  const double n = small_integer(draws, 1);
  return std::ldexp(n, draws.coin() ? 1023 : 0);
}
inline Point3d huge_or_small_point(DrawStream& draws) {
  return {huge_or_small(draws), huge_or_small(draws), huge_or_small(draws)};
}

/// The corners of a triangle in any of the six orders.
inline Triangle3d in_some_order(Triangle3d t, DrawStream& draws) {
  for (auto k = draws.below(3); k > 0; --k) t = {t.b, t.c, t.a};
  if (draws.coin()) std::swap(t.a, t.b);
  return t;
}

/// The ends of a segment that holds the point, or ends there, or leaves it aside: so many steps to either end.
inline Segment3d segment_through(DrawStream& draws, const Point3d& x, const Vector3d& displacement) {
  return {along(x, small_integer(draws, 2) - 1, displacement), along(x, small_integer(draws, 2), displacement)};
}

/// A point of one plane through the origin, +-2^-k times one of two vectors of 53 digits: no difference of two such
/// points is a double, and all of them are on the plane.
struct LongPlane {
  Vector3d u, v;

  static LongPlane of(DrawStream& draws) {
    const auto vector = [&draws] { return Vector3d{long_number(draws), long_number(draws), long_number(draws)}; };
    return {vector(), vector()};
  }
  Point3d point(DrawStream& draws) const {
    const double size = std::ldexp(1, -integer_in(draws, 0, 4)), k = either_sign(draws) * size;
    const Vector3d& along = draws.coin() ? u : v;
    return {k * along.x, k * along.y, k * along.z};
  }
};

}  // namespace touchstone::catalogue
