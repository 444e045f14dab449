// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/triangle_draws.h"
#include "catalogue/families/whole_steps.h"
#include "geometry/thin_shapes.h"

/// Segments of the plane and of space, and points at known places near them, drawn from a draw stream.
namespace touchstone::catalogue {

inline Segment2d without_z(const Segment3d& s) { return {{s.a.x, s.a.y}, {s.b.x, s.b.y}}; }
inline Point2d without_z(const Point3d& p) { return {p.x, p.y}; }

/// A line through a lattice point, and a lattice vector at a right angle to it, which may be 0. Where all is in the
/// plane, z is 0.
struct LatticeLine {
  bool in_plane;
  Point3d origin;
  Vector3d displacement, across;

  static LatticeLine of(DrawStream& draws) {
    const bool in_plane = draws.coin();
    Point3d origin = lattice_point_in_space(draws, 16);
    Vector3d displacement = lattice_normal(draws, 10), across = lattice_across(draws, displacement);
    if (in_plane) {
      origin.z = displacement.z = 0;
      if (displacement.x == 0 && displacement.y == 0) displacement.y = 1;
      const double k = small_integer(draws);
      across = {-k * displacement.y, k * displacement.x, 0};
    }
    return {in_plane, origin, displacement, across};
  }
  Point3d at(double i) const { return along(origin, i, displacement); }
  Segment3d between(double i, double j) const { return {at(i), at(j)}; }
};

/// An integer of 53 digits below 2^53: half more is halfway between two doubles, or, with a hair, next to that.
inline double halfway_number(DrawStream& draws) {
  return 0x1p52 + static_cast<double>(draws.below(std::uint64_t{1} << 51));
}

/// Nothing, or so little that no other digit of the number is near it.
inline double hair(DrawStream& draws) {
  const double side = small_integer(draws, 1);
  return std::ldexp(side, -100 - integer_in(draws, 0, 899));
}

/// A multiple of 3, 4, 5 whose hypotenuse is an odd number of 54 digits: halfway between two doubles.
struct HalfwayStep {
  double x, y;
};
inline HalfwayStep halfway_step(DrawStream& draws) {
  const double k = 1801439850948199 + 2 * static_cast<double>(draws.below(std::uint64_t{1} << 47));  // 2^53 / 5, odd
  return {3 * k, 4 * k};
}

/// -2^k, 0, 2^k ... : the greatest binades, where differences overflow, next to small numbers.
inline double of_full_range(DrawStream& draws) {
  const double n = small_integer(draws, 1);
  return std::ldexp(n, draws.coin() ? 1023 : integer_in(draws, -1, 1));
}
inline Point3d point_of_full_range(DrawStream& draws) {
  return {of_full_range(draws), of_full_range(draws), of_full_range(draws)};
}
/// Beside the least number.
inline Point3d subnormal_point(DrawStream& draws) { return {subnormal(draws), subnormal(draws), subnormal(draws)}; }
inline Point3d typed_point(DrawStream& draws) { return {typed(draws), typed(draws), typed(draws)}; }
/// Each coordinate 0 or -0.
inline Point3d zero_point(DrawStream& draws) { return {zero(draws), zero(draws), zero(draws)}; }

/// A way of whole length, and two ways across it, which may be parallel or 0.
struct IntegerAcross {
  Vector3d displacement, u, v;
  double length;

  static IntegerAcross of(DrawStream& draws) {
    const auto [n, length] = integer_normal(draws);
    const double k = one_to(draws, 64);
    return {k * n, lattice_across(draws, n), lattice_across(draws, n), k * length};
  }
};

/// A radius, or the sum of two, that just reaches so far, or a little more or less.
inline double reaching(DrawStream& draws, double length) {
  const double off = small_integer(draws, 1);
  return std::max(length + (draws.coin() ? off : off * 0x1p-30), 0.0);
}
/// The same as two radii; either may be 0.
struct Radii {
  double r, s;
};
inline Radii reaching_radii(DrawStream& draws, double length) {
  const double sum = reaching(draws, length), part = std::floor(sum * up_to(draws, 4) / 4);
  return {sum - part, part};
}

/// The double nearest to a length, or one a few ulps from it.
inline double near_length(DrawStream& draws, const Vector3d& v) {
  return std::fabs(moved_by_ulps(std::sqrt(dot(v, v)), integer_in(draws, -2, 2)));
}

/// x / r is next to the root of 2: x^2 - 2 r^2 is 1 or -1 (Pell).
struct NearRoot {
  double x, r;
};
inline NearRoot near_root(DrawStream& draws) {
  NearRoot found{1, 1};
  for (auto k = draws.below(40); k > 0; --k) found = {found.x + 2 * found.r, found.x + found.r};
  return found;
}

}  // namespace touchstone::catalogue
