// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <initializer_list>
#include <tuple>
#include <vector>

#include "catalogue/families/numbers.h"
#include "geometry/space.h"

/// Exact integers of space, drawn from a draw stream; the simplest first.
namespace touchstone::catalogue {

/// A lattice point of space, near the origin first.
inline Point3d lattice_point_in_space(DrawStream& draws, int bits = 26) {
  return {integer(draws, bits), integer(draws, bits), integer(draws, bits)};
}

/// The coordinates are drawn by number(draws).
template <class Draw>
Point3d point_of(DrawStream& draws, const Draw& number) {
  return {number(draws), number(draws), number(draws)};
}

/// 1 to 9 points, drawn by point().
template <class Draw>
std::vector<Point3d> some_points(DrawStream& draws, const Draw& point) {
  std::vector<Point3d> points(1 + draws.below(9));
  for (Point3d& p : points) p = point();
  return points;
}

/// One of {0, 1, 2}^3.
inline Point3d small_lattice_point(DrawStream& draws) { return {up_to(draws, 2), up_to(draws, 2), up_to(draws, 2)}; }

inline Point3d ordinary_point_in_space(DrawStream& draws) {
  return {ordinary(draws), ordinary(draws), ordinary(draws)};
}

/// A lattice vector that is not zero; (0, 1, 0) is the simplest.
inline Vector3d lattice_normal(DrawStream& draws, int bits = 20) {
  const double x = integer(draws, bits), y = integer(draws, bits), z = integer(draws, bits);
  return x == 0 && y == 0 && z == 0 ? Vector3d{0, 1, 0} : Vector3d{x, y, z};
}

/// A lattice vector at a right angle to n, perhaps zero: n x (small integers).
inline Vector3d lattice_across(DrawStream& draws, const Vector3d& n) {
  return cross(n, Vector3d{small_integer(draws), small_integer(draws), small_integer(draws)});
}

/// p, or a lattice point at most 1 away from it in each coordinate.
template <class T>
T beside(const T& p, DrawStream& draws, int most = 1) {
  return {p.x + small_integer(draws, most), p.y + small_integer(draws, most), p.z + small_integer(draws, most)};
}

/// p, or a point at most 2 ulps away from it in each coordinate.
inline Point3d beside_by_ulps(const Point3d& p, DrawStream& draws) {
  return {ulps_apart(draws, p.x, 2), ulps_apart(draws, p.y, 2), ulps_apart(draws, p.z, 2)};
}

/// Times 2^k; each coordinate by its own power of two.
template <class T>
T scaled(const T& p, int x, int y, int z) {
  return {std::ldexp(p.x, x), std::ldexp(p.y, y), std::ldexp(p.z, z)};
}
template <class T>
T scaled(const T& p, int k) {
  return scaled(p, k, k, k);
}

/// change(p) for each point and each vector of a shape.
template <class Shape, class Change>
void change_each(Shape& shape, const Change& change) {
  if constexpr (requires { shape.vertices; }) {
    for (Point3d& p : shape.vertices) change(p);
  } else if constexpr (requires { shape.half_axes; }) {
    change(shape.center), change(shape.half_axes.u), change(shape.half_axes.v), change(shape.half_axes.w);
  } else if constexpr (requires { shape.direction; }) {
    change(shape.origin), change(shape.direction);
  } else if constexpr (requires { shape.min; }) {
    change(shape.min), change(shape.max);
  } else if constexpr (requires { shape.a; }) {
    change(shape.a), change(shape.b);
    if constexpr (requires { shape.c; }) change(shape.c);
  } else {
    change(shape);
  }
}

/// Each axis times a power of two of its own, past the lattice, past the filter's guard, below its absolute term.
class Stretch {
 public:
  explicit Stretch(DrawStream& draws, std::initializer_list<int> exponents = {0, 60, 255, -170, 300, -300}) {
    for (int& exponent : exponents_) exponent = exponents.begin()[draws.below(exponents.size())];
  }
  template <class... Shapes>
  void operator()(Shapes&... shapes) const {
    const auto change = [this](auto& p) { p = scaled(p, exponents_[0], exponents_[1], exponents_[2]); };
    (change_each(shapes, change), ...);
  }

 private:
  std::array<int, 3> exponents_{};
};

/// A normal whose length is an integer; (0, 1, 0) is the simplest.
struct IntegerNormal {
  Vector3d n;
  double length;
};
inline IntegerNormal integer_normal(DrawStream& draws) {
  static constexpr IntegerNormal normals[]{
      {{0, 1, 0}, 1}, {{1, 2, 2}, 3}, {{3, 4, 0}, 5}, {{2, 3, 6}, 7}, {{1, 4, 8}, 9}};
  return normals[draws.below(5)];
}

/// Three products of about half of the least subnormal number each, and an offset of one to three times that number.
inline std::tuple<Plane3d, Point3d> terms_below_least(DrawStream& draws) {
  const int k = integer_in(draws, -500, 499);
  const double a = std::ldexp(8 + up_to(draws, 7), k), b = std::ldexp(8 + up_to(draws, 7), -1082 - k);
  return {{{a, a, a}, -std::ldexp(one_to(draws, 3), -1074)}, {b, b, b}};
}

}  // namespace touchstone::catalogue
