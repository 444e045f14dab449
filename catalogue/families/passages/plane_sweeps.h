// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "catalogue/families/half_space_draws.h"
#include "catalogue/families/ties.h"

/// Hard cases of a ball, or of what has one as its end, that moves towards a plane.
namespace touchstone::catalogue {

using MovingBall = std::tuple<Sphere3d, Vector3d, Plane3d>;

/// Height of the center, radius and fall of a step in units of the length of a normal that is an integer; the
/// plane goes through a lattice point; seen from either side.
inline MovingBall of_integer_length(DrawStream& c, double height, double radius, double fall) {
  const auto [n, length] = integer_normal(c);
  const Point3d foot = lattice_point_in_space(c, 10);
  const Vector3d aside = lattice_across(c, n), drift = lattice_across(c, n);
  const double side = either_sign(c);
  const Point3d center = foot + (aside + (side * height) * n);
  return {{center, radius * length}, drift - (side * fall) * n, {n, -dot(n, Vector3d{foot.x, foot.y, foot.z})}};
}

/// Calls add(name, draw) for each.
template <class Add>
void add_balls_to_planes(const Add& add) {
  add("approach", [](DrawStream& c) -> MovingBall {
    const double radius = up_to(c, 5), gap = one_to(c, 8);
    return of_integer_length(c, radius + gap, radius, gap + small_integer(c));
  });
  add("touching_at_start", [](DrawStream& c) -> MovingBall {
    const double radius = up_to(c, 5);
    return of_integer_length(c, radius, radius, small_integer(c));
  });
  add("contact_at_end", [](DrawStream& c) -> MovingBall {
    const double radius = up_to(c, 5), gap = one_to(c, 8);
    return of_integer_length(c, radius + gap, radius, gap);
  });
  add("overlaps_at_start", [](DrawStream& c) -> MovingBall {
    const double radius = one_to(c, 6), aside = small_integer(c);
    return of_integer_length(c, static_cast<double>(c.below(static_cast<std::uint64_t>(radius))), radius, aside);
  });
  add("along_plane", [](DrawStream& c) -> MovingBall {
    const double radius = up_to(c, 5), off = small_integer(c, 1);
    return of_integer_length(c, radius + off, radius, 0);
  });
  add("points", [](DrawStream& c) -> MovingBall {
    const double height = up_to(c, 3);
    return of_integer_length(c, height, 0, small_integer(c, 6));
  });
  add("irrational", [](DrawStream& c) -> MovingBall {
    const Vector3d n = lattice_normal(c, 10), v = lattice_normal(c, 10);
    return {{lattice_point_in_space(c, 10), up_to(c, 11)}, v, {n, integer(c, 10)}};
  });
  add("rounded_touch", [](DrawStream& c) -> MovingBall {
    // A touch at the start or at the end, as far as doubles can tell.
    const Vector3d n{ordinary(c), ordinary(c), 1}, p{ordinary(c), ordinary(c), ordinary(c)};
    const double d = ordinary(c);
    const Vector3d v{ordinary(c), ordinary(c), ordinary(c)}, at = c.coin() ? p + v : p;
    return {{{p.x, p.y, p.z}, within_ulps(c, std::fabs(dot(n, at) + d) / std::sqrt(dot(n, n)), 1)}, v, {n, d}};
  });
  add("beside_a_tie", [](DrawStream& c) -> MovingBall {
    const auto [low, high, fall] = way_beside_tie(c);
    return {{{0, high, 0}, 0}, {0, -fall * 0x1p54, 0}, {{0, 1, 0}, low}};
  });
  add("uneven_normal", [](DrawStream& c) -> MovingBall {
    // Past the guards of the squared length, or with parts that count for nothing.
    const int k = integer_in(c, -1050, 949), m = integer_in(c, -300, 299);
    const double x = small_integer(c), y = small_integer(c), d = small_integer(c), r = small_integer(c, 2);
    const Vector3d n{std::ldexp(1 + small_integer(c, 1) / 4, k), std::ldexp(y, k + m), 0};
    return {{{x, y, 0}, std::fabs(r)}, {-2 * x, small_integer(c), 0}, {n, std::ldexp(d, k)}};
  });
  add("normal_of_few_digits", [](DrawStream& c) -> MovingBall {
    // Its square is subnormal, and off by more than nothing; the ball touches the plane at the start.
    const int k = integer_in(c, -540, -517);
    const double n = std::ldexp(5 + up_to(c, 2), k), x = one_to(c, 6);
    return {{{x, 0, 0}, x}, {small_integer(c), 0, 0}, {{n, 0, 0}, 0}};
  });
  add("least_beside_greatest", [](DrawStream& c) -> MovingBall {
    const double least = subnormal(c), greatest = huge(c);
    const double d = c.coin() ? least : -greatest, y = c.coin() ? greatest : 4, r = c.coin() ? std::fabs(least) : 1;
    return {{{0, y, least}, r}, {0, -y, least}, {{0, 1, c.coin() ? 1.0 : least}, d}};
  });
  add("starts_below_least", [](DrawStream& c) -> MovingBall {
    const auto [plane, start] = terms_below_least(c);
    return {{start, 0}, {small_integer(c, 1), 1, -1}, plane};
  });
  add("either_zero", [](DrawStream& c) -> MovingBall {
    const double x = zero(c), y = zero(c), r = zero(c), v = zero(c), n = zero(c), d = zero(c);
    return {{{x, c.coin() ? 1 : y, 0}, r}, {v, small_integer(c, 1), 0}, {{n, 1, 0}, d}};
  });
}

}  // namespace touchstone::catalogue
