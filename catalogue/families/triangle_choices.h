// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/long_choices.h"
#include "catalogue/families/space_choices.h"
#include "geometry/triangles.h"

/// Points, segments and triangles of space in exact positions, drawn from a stream of choices.
namespace touchstone::catalogue {

/// p + i v, exactly, for numbers of few digits.
inline Point3d along(const Point3d& p, double i, const Vector3d& v) { return p + i * v; }

/// One of {0, 1, 2}^3.
inline Point3d small_lattice_point(Choices& choices) {
  const auto digit = [&choices] { return static_cast<double>(choices.below(3)); };
  const double x = digit(), y = digit();
  return {x, y, digit()};
}

inline Point3d ordinary_point_in_space(Choices& choices) {
  const double x = ordinary(choices), y = ordinary(choices);
  return {x, y, ordinary(choices)};
}

/// A lattice plane, through a point and along two vectors, which may be parallel.
struct LatticePlane {
  Point3d origin;
  Vector3d u, v;

  static LatticePlane of(Choices& choices, int bits = 12) {
    const Point3d origin = lattice_point_in_space(choices, bits);
    const Vector3d u = lattice_normal(choices, bits);
    return {origin, u, lattice_normal(choices, bits)};
  }
  Point3d at(double i, double j) const { return along(along(origin, i, u), j, v); }
  /// A few steps from the origin.
  Point3d point(Choices& choices, int most = 3) const {
    const double i = small_integer(choices, most);
    return at(i, small_integer(choices, most));
  }
  Triangle3d triangle(Choices& choices) const {
    const Point3d a = point(choices), b = point(choices);
    return {a, b, point(choices)};
  }
};

/// The ends of a segment that holds the point, or ends there, or leaves it aside: so many steps to either end.
inline Segment3d segment_through(Choices& choices, const Point3d& x, const Vector3d& way) {
  const double before = small_integer(choices, 2);
  return {along(x, before - 1, way), along(x, small_integer(choices, 2), way)};
}

/// A point of one plane through the origin, +-2^-k times one of two vectors of 53 digits: no difference of two such
/// points is a double, and all of them are on the plane.
struct LongPlane {
  Vector3d u, v;

  static LongPlane of(Choices& choices) {
    const auto vector = [&choices] {
      const double x = long_number(choices), y = long_number(choices);
      return Vector3d{x, y, long_number(choices)};
    };
    const Vector3d u = vector();
    return {u, vector()};
  }
  Point3d point(Choices& choices) const {
    const double size = std::ldexp(1, -static_cast<int>(choices.below(5))), k = choices.below(2) == 1 ? -size : size;
    const Vector3d& along = choices.below(2) == 1 ? u : v;
    return {k * along.x, k * along.y, k * along.z};
  }
};

/// Each axis times a power of two of its own, past the lattice, past the filter's guard, below its absolute term.
template <class... Points>
void stretch(Choices& choices, Points&... points) {
  static constexpr int exponents[]{0, 60, 255, -170, 300, -300};
  const int x = exponents[choices.below(6)], y = exponents[choices.below(6)], z = exponents[choices.below(6)];
  ((points = {std::ldexp(points.x, x), std::ldexp(points.y, y), std::ldexp(points.z, z)}), ...);
}

}  // namespace touchstone::catalogue
