// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "catalogue/families/closest_draws.h"
#include "geometry/capsules.h"
#include "geometry/volumes.h"

/// The hooks and hard cases that rows of a solid and a plane, or the half-space behind it, share.
namespace touchstone::catalogue {

/// Hooks of questions whose last part is the plane.
template <class... Parts>
struct OverPlane {
  /// The normal has no unit: it keeps its value.
  static void scale(std::tuple<Parts..., Plane3d>& question, int k) {
    const auto longer = [k](double& length) { length = std::ldexp(length, k); };
    std::apply([&](auto&... part) { (scale_part(part, longer), ...); }, question);
  }

 private:
  static void scale_part(auto& part, const auto& longer) { for_each_number(part, longer); }
  static void scale_part(Plane3d& plane, const auto& longer) { longer(plane.offset); }
};

using BallAndPlane = std::tuple<Sphere3d, Plane3d>;

/// A capsule of which the ball is an end. The other is the same point, one as high, higher, lower, or far from there.
inline Capsule3d with_end(DrawStream& c, const Sphere3d& ball, const Vector3d& n) {
  const Point3d& p = ball.center;
  const double steps = small_integer(c, 3);
  const Vector3d across = lattice_across(c, n);
  const auto other = [&]() -> Point3d {
    switch (c.below(4)) {
      case 0: return p + across;
      case 1: return p + (across + std::fabs(steps) * n);
      case 2: return p + (across + steps * n);
      default: return lattice_point_in_space(c);
    }
  };
  const Point3d q = other();
  const bool first = c.coin();
  return {{first ? p : q, first ? q : p}, ball.radius};
}

/// Height of the center and radius in units of the length of the normal; the plane goes through a lattice point.
inline BallAndPlane ball_over_plane(DrawStream& c, double height, double radius) {
  const auto [n, length] = integer_normal(c);
  const Point3d foot = lattice_point_in_space(c, 10), center = foot + (lattice_across(c, n) + height * n);
  return {{center, radius * length}, {n, -dot(n, Vector3d{foot.x, foot.y, foot.z})}};
}

/// Calls add(name, draw) for each: a ball, or what has one as its end, and a plane.
template <class Add>
void add_balls_over_planes(const Add& add) {
  add("tangent", [](DrawStream& c) -> BallAndPlane {
    const double radius = one_to(c, 6), off = small_integer(c, 1);
    return ball_over_plane(c, c.coin() ? -radius - off : radius + off, radius);
  });
  add("point_or_nearly", [](DrawStream& c) -> BallAndPlane {
    const double radius = std::ldexp(up_to(c, 3), -1074), height = small_integer(c);
    return ball_over_plane(c, height, radius);
  });
  add("beside_root", [](DrawStream& c) -> BallAndPlane {
    const auto [x, r] = near_root(c);
    return {{{x, 0, integer(c, 20)}, r}, {{1, either_sign(c), 0}, 0}};
  });
  add("rounded_tangent", [](DrawStream& c) -> BallAndPlane {
    const Vector3d n{ordinary(c), ordinary(c), 1}, p{ordinary(c), ordinary(c), ordinary(c)};
    const double d = ordinary(c), reach = std::fabs(dot(n, p) + d) / std::sqrt(dot(n, n));
    return {{{p.x, p.y, p.z}, std::fabs(within_ulps(c, reach, 1))}, {n, d}};
  });
  add("typed_tangent", [](DrawStream& c) -> BallAndPlane {
    // As typed the ball reaches the plane.
    const double k = one_to(c, 9), m = one_to(c, 9);
    return {{{0, (m + k) / 10, 0}, k / 10}, {{0, 1, 0}, -m / 10}};
  });
  add("normal_of_any_size", [](DrawStream& c) -> BallAndPlane {
    // Past the guards of the squared length, and where that is subnormal; tangent but for a part that counts for
    // little, or for nothing.
    const int k = integer_in(c, -1050, 949), m = integer_in(c, 0, 299);
    const double n = std::ldexp(5 + up_to(c, 2), k), x = one_to(c, 6);
    return {{{x, 0, 0}, x}, {{n, std::ldexp(small_integer(c, 1), k - m), 0}, 0}};
  });
  add("terms_below_least", [](DrawStream& c) -> BallAndPlane {
    const auto [plane, center] = terms_below_least(c);
    return {{center, std::ldexp(up_to(c, 2), -1074)}, plane};
  });
  add("tangent_but_for_a_hair", [](DrawStream& c) -> BallAndPlane {
    // At sizes within the filter's guards and beyond.
    const double radius = scaled_up(c, 4, 1020), off = small_integer(c, 1);
    const double hair = std::ldexp(off, -integer_in(c, 0, 1073));
    return {{{0, either_sign(c) * radius, 0}, radius}, {{0, 1, 0}, hair}};
  });
  add("whole_range", [](DrawStream& c) -> BallAndPlane {
    // Products overflow, and where nothing does, their sum.
    const double great = huge(c), r = c.coin() ? great : 1;
    const double y = c.coin() ? great : small_integer(c), n = c.coin() ? great : 1;
    return {{{great, y, 0}, r}, {{0, n, 0}, c.one_in(3) ? -great : small_integer(c, 1)}};
  });
  add("either_zero", [](DrawStream& c) -> BallAndPlane {
    const double x = zero(c), y = zero(c), r = zero(c), n = zero(c), d = zero(c), height = small_integer(c, 1);
    return {{{x, c.coin() ? height : y, 0}, c.coin() ? 1 : r}, {{n, 1, n}, d}};
  });
  add("zero_normal", [](DrawStream& c) -> BallAndPlane {
    const Vector3d n{0.0, zero(c), 0.0};
    return {{lattice_point_in_space(c), 1}, {n, small_integer(c)}};
  });
}

}  // namespace touchstone::catalogue
