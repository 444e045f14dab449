// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "catalogue/families/hard_case.h"
#include "catalogue/families/triangle_draws.h"
#include "catalogue/shape/walk.h"
#include "geometry/rays.h"

/// Families of a plane and a line that starts at one point and leads to another.
namespace touchstone::catalogue {

/// Two points on the lattice at these heights over a plane through lattice points, in units of N . N.
struct PlaneAndPoints {
  Plane3d plane;
  Point3d from, to;
};
inline PlaneAndPoints at_heights(DrawStream& c, double from, double to) {
  const Vector3d n = lattice_normal(c, 10);
  const Point3d foot = lattice_point_in_space(c), start = foot + lattice_across(c, n) + from * n;
  return {{n, -dot(n, Vector3d{foot.x, foot.y, foot.z})}, start, foot + lattice_across(c, n) + to * n};
}

/// Row::of(plane, from, to): the question whose line leads from the one point to the other.
template <class Row>
void line_plane_cases(HardCases<typename Row::Question>& add) {
  using Question = typename Row::Question;
  add("crossing", [](DrawStream& c) -> Question {
    const double up = one_to(c, 8), down = -one_to(c, 8);
    const bool upwards = c.coin();
    const auto [plane, from, to] = at_heights(c, upwards ? down : up, upwards ? up : down);
    return Row::of(plane, from, to);
  });
  add("starts_on_plane", [](DrawStream& c) -> Question {
    const auto [plane, from, to] = at_heights(c, 0, small_integer(c));
    return Row::of(plane, from, to);
  });
  add("reaches_plane_at_one", [](DrawStream& c) -> Question {
    const auto [plane, from, to] = at_heights(c, small_integer(c), 0);
    return Row::of(plane, from, to);
  });
  add("on_one_side", [](DrawStream& c) -> Question {
    const double side = either_sign(c), first = side * one_to(c, 8), then = side * one_to(c, 8);
    const auto [plane, from, to] = at_heights(c, first, then);
    return Row::of(plane, from, to);
  });
  add("along_plane", [](DrawStream& c) -> Question {
    const double height = small_integer(c, 1);
    const auto [plane, from, to] = at_heights(c, height, height);
    return Row::of(plane, from, to);
  });
  add("no_length", [](DrawStream& c) -> Question {
    const auto [plane, from, to] = at_heights(c, small_integer(c, 1), 0);
    return Row::of(plane, from, from);
  });
  add("nearly_along_plane", [](DrawStream& c) -> Question {
    // t is 2^k: beyond 1, beyond the lattice, beyond the range.
    const double fall = -scaled_down(c, 4, 1074);
    const double height = scaled_up(c, 4, 60), x = small_integer(c);
    return Row::of({{0, 1, 0}, -height}, {x, height, 0}, {x + 1, height + fall, 0});
  });
  add("from_far_away", [](DrawStream& c) -> Question {
    const double y = scaled_up(c, 1 << 20, 30);
    const Vector3d n = lattice_normal(c, 10);
    const Point3d foot = lattice_point_in_space(c, 10);
    const double off = small_integer(c, 1), to = small_integer(c, 1);
    return Row::of({n, off - dot(n, Vector3d{foot.x, foot.y, foot.z})}, foot + y * n, foot + to * n);
  });
  add("rounded_on_plane", [](DrawStream& c) -> Question {
    const double nx = ordinary(c), ny = ordinary(c), nz = 1 + std::fabs(ordinary(c));
    const double x = ordinary(c), y = ordinary(c), z = ordinary(c);
    const Vector3d n{nx, ny, nz};
    const Point3d p{x, y, z}, away = p + one_to(c, 8) * n;
    return c.coin() ? Row::of({n, -dot(n, Vector3d{x, y, z})}, p, away)
                    : Row::of({n, -dot(n, Vector3d{x, y, z})}, away, p);
  });
  add("typed_heights", [](DrawStream& c) -> Question {
    const double above = std::fabs(typed(c)), below = std::fabs(typed(c)), d = typed(c), x = typed(c);
    return Row::of({{0, 1, 0}, -d}, {x, d + above, 0.3}, {0.2, d - below, 0.1});
  });
  add("beside_a_tie", [](DrawStream& c) -> Question {
    // At t = 1/2, a coordinate halfway between two doubles but for one bit, about 64 digits below the first.
    return Row::of({{0, 1, 0}, 0}, {1, 1, 1}, {beside_half_an_ulp(c, -62, 4), -1, 0});
  });
  add("last_binade", [](DrawStream& c) -> Question {
    const double x = std::ldexp(16 + up_to(c, 15), 1019), up = one_to(c, 8), down = -one_to(c, 8);
    return Row::of({{0, 1, 0}, 0}, {x, up, 0}, {x, down, 0});
  });
  add("starts_below_least", [](DrawStream& c) -> Question {
    const auto [plane, from] = terms_below_least(c);
    const Point3d to = c.coin() ? Point3d{1, 1, 1} : Point3d{-from.x, -from.y, -from.z};
    return Row::of(plane, from, to);
  });
  add("starts_subnormal", [](DrawStream& c) -> Question {
    // A huge normal makes it count.
    const double offset = std::ldexp(one_to(c, 64), -531), x = std::ldexp(offset, -499);
    return Row::of({{0x1p500, 0, 0}, -offset}, {x, 0, 0}, {-3 * x, 0, 0});
  });
  add("whole_range", [](DrawStream& c) -> Question {
    // Products overflow, and differences, and what is found does not.
    const Plane3d plane{{huge_or_small(c), huge_or_small(c), 1}, huge_or_small(c)};
    const Point3d from = huge_or_small_point(c);
    return Row::of(plane, from, huge_or_small_point(c));
  });
  add("either_zero", [](DrawStream& c) -> Question {
    const double nx = zero(c), nz = zero(c), d = zero(c), x = zero(c), y = zero(c), z = zero(c), to_x = zero(c);
    const double from_y = c.coin() ? 1 : y, to_y = small_integer(c, 1);
    return Row::of({{nx, 1, nz}, d}, {x, from_y, z}, {to_x, to_y, 1});
  });
  add("zero_normal", [](DrawStream& c) -> Question {
    const Vector3d n{0.0, zero(c), 0.0};
    const Point3d from = lattice_point_in_space(c);
    const double d = small_integer(c);
    return Row::of({n, d}, from, from + lattice_normal(c));
  });
}

/// The normal has no unit: it keeps its value.
template <class Question>
void scale_line_and_plane(Question& question, int k) {
  auto& [line, plane] = question;
  for_each_number(line, [k](double& length) { length = std::ldexp(length, k); });
  plane.offset = std::ldexp(plane.offset, k);
}

}  // namespace touchstone::catalogue
