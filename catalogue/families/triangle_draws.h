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

/// One of {0, 1, 2}^3.
inline Point3d small_lattice_point(DrawStream& draws) {
  const auto digit = [&draws] { return up_to(draws, 2); };
  const double x = digit(), y = digit();
  return {x, y, digit()};
}

inline Point3d ordinary_point_in_space(DrawStream& draws) {
  const double x = ordinary(draws), y = ordinary(draws);
  return {x, y, ordinary(draws)};
}

/// A lattice plane, through a point and along two vectors, which may be parallel.
struct LatticePlane {
  Point3d origin;
  Vector3d u, v;

  static LatticePlane of(DrawStream& draws, int bits = 12) {
    const Point3d origin = lattice_point_in_space(draws, bits);
    const Vector3d u = lattice_normal(draws, bits);
    return {origin, u, lattice_normal(draws, bits)};
  }
  Point3d at(double i, double j) const { return along(along(origin, i, u), j, v); }
  /// A few steps from the origin.
  Point3d point(DrawStream& draws, int most = 3) const {
    const double i = small_integer(draws, most);
    return at(i, small_integer(draws, most));
  }
  Triangle3d triangle(DrawStream& draws) const {
    const Point3d a = point(draws), b = point(draws);
    return {a, b, point(draws)};
  }
};

/// The corners of a triangle in any of the six orders.
inline Triangle3d in_some_order(Triangle3d t, DrawStream& draws) {
  for (auto k = draws.below(3); k > 0; --k) t = {t.b, t.c, t.a};
  if (draws.coin()) std::swap(t.a, t.b);
  return t;
}

/// The ends of a segment that holds the point, or ends there, or leaves it aside: so many steps to either end.
inline Segment3d segment_through(DrawStream& draws, const Point3d& x, const Vector3d& way) {
  const double before = small_integer(draws, 2);
  return {along(x, before - 1, way), along(x, small_integer(draws, 2), way)};
}

/// A point of one plane through the origin, +-2^-k times one of two vectors of 53 digits: no difference of two such
/// points is a double, and all of them are on the plane.
struct LongPlane {
  Vector3d u, v;

  static LongPlane of(DrawStream& draws) {
    const auto vector = [&draws] {
      const double x = long_number(draws), y = long_number(draws);
      return Vector3d{x, y, long_number(draws)};
    };
    const Vector3d u = vector();
    return {u, vector()};
  }
  Point3d point(DrawStream& draws) const {
    const double size = std::ldexp(1, -integer_in(draws, 0, 4)), k = either_sign(draws) * size;
    const Vector3d& along = draws.coin() ? u : v;
    return {k * along.x, k * along.y, k * along.z};
  }
};

/// Each axis times a power of two of its own, past the lattice, past the filter's guard, below its absolute term.
template <class... Points>
void stretch(DrawStream& draws, Points&... points) {
  static constexpr int exponents[]{0, 60, 255, -170, 300, -300};
  const int x = exponents[draws.below(6)], y = exponents[draws.below(6)], z = exponents[draws.below(6)];
  ((points = {std::ldexp(points.x, x), std::ldexp(points.y, y), std::ldexp(points.z, z)}), ...);
}

}  // namespace touchstone::catalogue
