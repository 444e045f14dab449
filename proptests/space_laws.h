// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proptests/forward_error.h"

/// Laws of questions in space.
namespace touchstone::proptests {

/// An exchange of the axes with signs, the normal turned with them: exact for every double.
struct AxisMap {
  int from[3];
  double sign[3];

  template <class T>
  requires requires(T v) { v.x, v.y, v.z; }
  void place(T& v) const {
    const auto old = v;
    const auto part = [&](int i) { return from[i] == 0 ? old.x : from[i] == 1 ? old.y : old.z; };
    const auto turned = [&](int i) { return decltype(old.x)(sign[i] < 0 ? -part(i) : part(i)); };
    v = {turned(0), turned(1), turned(2)};
  }
  template <class T>
  T operator()(T value) const {
    for_each_part(value, *this);
    return value;
  }
};

/// The axes turned round, exchanged (a reflection), and turned over; with the first two every signed exchange can be
/// made.
inline constexpr std::array<AxisMap, 4> axis_maps{
    {{{1, 2, 0}, {1, 1, 1}}, {{1, 0, 2}, {1, 1, 1}}, {{0, 1, 2}, {1, -1, 1}}, {{2, 0, 1}, {-1, 1, -1}}}};

/// Whether every number is an integer of at most 40 bits, so that small integer shifts and multiples do not round.
template <class Asked>
bool on_small_lattice(const Asked& asked) {
  bool whole = true;
  catalogue::for_each_number(asked,
                             [&](const double& n) { whole = whole && std::fabs(n) <= 0x1p40 && n == std::trunc(n); });
  return whole;
}

/// A plane's equation times a power of two where that is exact, or times 3 on the lattice, is the same plane; it is the
/// question's part of that number.
template <std::size_t plane>
inline constexpr auto any_equation_of_the_plane = [](const auto& ask, const auto& asked) {
  const auto answer = ask(asked);
  const auto keeps = [&](const Plane3d& other) {
    auto question = asked;
    std::get<plane>(question) = other;
    return equal(ask(question), answer);
  };
  const auto times = [](const Plane3d& by, double factor) { return Plane3d{factor * by.normal, factor * by.offset}; };
  const Plane3d& given = std::get<plane>(asked);
  for (const int k : {1, -1, 60, -60, 500, -500}) {
    const Plane3d longer = times(given, std::ldexp(1, k));
    const auto& [x, y, z] = longer.normal;
    if (!finite(x, y, z, longer.offset) || numbers_of(times(longer, std::ldexp(1, -k))) != numbers_of(given)) continue;
    if (!keeps(longer)) return false;
  }
  return !on_small_lattice(asked) || keeps(times(given, 3));
};

/// N . p + d as the slide's formula computes it, and the bound e(E) of reference/planes/point_plane.h.
struct HeightBound {
  double computed;
  bool overflow;
  Rational error;

  HeightBound(const Plane3d& plane, const Point3d& p) {
    const double x = plane.normal.x * p.x, y = plane.normal.y * p.y, z = plane.normal.z * p.z;
    computed = x + y + z + plane.offset;
    overflow = !finite(x, y, z, x + y, x + y + z, computed);
    if (overflow) return;
    const Rational u = unit();
    error = (4 + 16 * u) * u * (size(x) + size(y) + size(z) + size(plane.offset)) + power_of_two(-1073);
  }
  bool certain() const { return !overflow && size(computed) > error; }
};

/// Distance of the centers and sum of the radii of two balls, squared.
struct Squares {
  Rational distance, reach;
};
template <class Ball>
Squares squares(const Ball& a, const Ball& b) {
  const auto squared = [](const Rational& x) { return Rational(x * x); };
  Rational distance = squared(exact(b.center.x) - exact(a.center.x)) + squared(exact(b.center.y) - exact(a.center.y));
  if constexpr (requires { a.center.z; }) distance += squared(exact(b.center.z) - exact(a.center.z));
  return {distance, squared(exact(a.radius) + exact(b.radius))};
}
/// |S - R| exceeds its bound, of the contract of sphere_sphere.
template <class Ball>
bool certain(const Ball& a, const Ball& b) {
  const auto between = b.center - a.center;
  const double sum = a.radius + b.radius;
  if (!finite(dot(between, between), sum * sum)) return false;
  const auto [s, r] = squares(a, b);
  const Rational u = unit();
  return abs(s - r) > (5 + 11 * u) * u * s + (3 + 4 * u) * u * r + power_of_two(-1072);
}

/// The test case of any_equation_of_the_plane, in the types of the file's `Row`.
#define EQUATION_LAW(operation, plane)                                                                               \
  TEST_CASE(operation ": the plane's equation times a power of two, or times 3 on the lattice, is the same plane") { \
    law<Row>("the same plane", any_equation_of_the_plane<plane>);                                                    \
  }

}  // namespace touchstone::proptests
