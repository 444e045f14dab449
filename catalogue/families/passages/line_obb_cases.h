// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/closest_draws.h"
#include "catalogue/families/obb_draws.h"
#include "catalogue/families/passages/line_solid_cases.h"
#include "catalogue/families/ties.h"

/// Families of a line and an oriented box. Row::of(course, box): the question whose line has that course.
namespace touchstone::catalogue {

/// A point of an edge that is along w, or one of its ends, and a direction of which the line through it only touches
/// there, or, with the other sign of v, passes through the box.
inline Course course_by_edge(DrawStream& c, const Obb3d& box, bool corner) {
  const auto& [u, v, w] = box.half_axes;
  const double one = 2 * either_sign(c), other = 2 * either_sign(c), t = corner ? 2 : small_integer(c, 2);
  const Point3d x = halves_along(box, one, other, t);
  const double i = one_to(c, 2) * one, j = one_to(c, 2) * other, k = small_integer(c, 2);
  return course_through(c, x, i * u + ((c.coin() ? j : -j) * v + k * w));
}

template <class Row>
void line_obb_cases(HardCases<typename Row::Question>& add) {
  using Question = typename Row::Question;
  add("through_inside", [](DrawStream& c) -> Question {
    const Obb3d box = lattice_obb(c);
    const Point3d x = in_obb(box, c);
    return Row::of(course_through(c, x, lattice_normal(c, 6)), box);
  });
  add("through_boundary", [](DrawStream& c) -> Question {
    const Obb3d box = lattice_obb(c);
    const Point3d x = on_obb(box, c);
    return Row::of(course_through(c, x, lattice_normal(c, 6)), box);
  });
  add("by_edge", [](DrawStream& c) -> Question {
    const Obb3d box = lattice_obb(c);
    return Row::of(course_by_edge(c, box, false), box);
  });
  add("by_corner", [](DrawStream& c) -> Question {
    const Obb3d box = lattice_obb(c);
    return Row::of(course_by_edge(c, box, true), box);
  });
  add("along_face", [](DrawStream& c) -> Question {
    // In its plane, or half of a half axis beyond it.
    const Obb3d box = lattice_obb(c);
    const auto& [u, v, w] = box.half_axes;
    const double side = either_sign(c), beyond = up_to(c, 1), s = small_integer(c, 2), t = small_integer(c, 2);
    const double i = one_to(c, 2), j = small_integer(c, 2);
    return Row::of(course_through(c, halves_along(box, side * (2 + beyond), s, t), i * v + j * w), box);
  });
  add("along_edge", [](DrawStream& c) -> Question {
    const Obb3d box = lattice_obb(c);
    const double one = 2 * either_sign(c), other = 2 * either_sign(c), off = small_integer(c, 1);
    const Point3d x = halves_along(box, one, other + off, small_integer(c, 2));
    return Row::of(course_through(c, x, either_sign(c) * box.half_axes.w), box);
  });
  add("starts_on_boundary", [](DrawStream& c) -> Question {
    const Obb3d box = lattice_obb(c);
    const Point3d x = on_obb(box, c);
    return Row::of({x, lattice_normal(c, 6)}, box);
  });
  add("starts_inside", [](DrawStream& c) -> Question {
    const Obb3d box = lattice_obb(c);
    const Point3d x = in_obb(box, c);
    return Row::of({x, lattice_normal(c, 6)}, box);
  });
  add("no_length", [](DrawStream& c) -> Question {
    const Obb3d box = lattice_obb(c);
    Point3d x = on_obb(box, c);
    x.x += small_integer(c, 1);
    return Row::of({x, {0, -0.0, 0}}, box);
  });
  add("along_the_axes", [](DrawStream& c) -> Question {
    // A box along the axes, and a direction along one, or diagonal.
    const Obb3d box{{0, 0, 0}, straight_half_axes(c)};
    const double x = small_integer(c), y = small_integer(c), z = small_integer(c);
    const double i = small_integer(c, 1), j = small_integer(c, 1);
    return Row::of(course_through(c, {x, y, z}, {i, j, i == 0 && j == 0 ? 1.0 : zero(c)}), box);
  });
  add("nearly_dependent", [](DrawStream& c) -> Question {
    const Obb3d box{lattice_point_in_space(c, 20), slanted_half_axes(c)};
    const Point3d x = beside(on_obb(box, c), c);
    return Row::of(course_through(c, x, lattice_normal(c, 4)), box);
  });
  add("dependent", [](DrawStream& c) -> Question {
    const Vector3d u = lattice_normal(c), v = lattice_normal(c);
    const double r = small_integer(c), s = small_integer(c);
    return Row::of({lattice_point_in_space(c, 20), {1, 0, 0}}, {{0, 0, 0}, {u, r * u + s * v, v}});
  });
  add("from_far_away", [](DrawStream& c) -> Question {
    const Obb3d box{{0, 0, 0}, c.coin() ? turned_half_axes(c) : skew_half_axes(c)};
    const Point3d x = on_obb(box, c);
    return Row::of(course_from_afar(c, x, lattice_normal(c, 3)), box);
  });
  add("direction_of_any_size", [](DrawStream& c) -> Question {
    const Obb3d box = lattice_obb(c);
    const Point3d x = in_obb(box, c);
    const Vector3d v = lattice_normal(c, 6);
    const auto [from, displacement] = course_through(c, x, v);
    return Row::of({from, of_any_size(c, displacement)}, box);
  });
  add("rounded_by_edge", [](DrawStream& c) -> Question {
    // As far as doubles can tell it grazes an edge.
    const Obb3d box{ordinary_point_in_space(c), ordinary_half_axes(c)};
    return Row::of(course_by_edge(c, box, c.coin()), box);
  });
  add("beside_a_tie", [](DrawStream& c) -> Question {
    // The entry, in units of 2^-54.
    const auto [low, high, speed] = way_beside_tie(c);
    return Row::of({{-low, 0, 0}, {speed * 0x1p54, 0, 0}},
                   {{high + 0x1p32, 0, 0}, {{0x1p32, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  });
  add("halfway", [](DrawStream& c) -> Question {
    // Within the numbers that enclosures take: the way in is an odd integer of 54 digits, in units of 2^-24.
    const double i = up_to(c, 1000) * 0x1p-23, size = power_of_two(c, 0, 30), y = small_integer(c, 1);
    return Row::of({{-0x1p-24, y, 0}, {size, 0, 0}}, {{0x1p29 + i + 1, 0, 0}, {{1, 0, 0}, {0, 2, 0}, {0, 0, 1}}});
  });
  add("stretched", [](DrawStream& c) -> Question {
    Obb3d box = lattice_obb(c);
    auto [from, displacement] = course_by_edge(c, box, c.coin());
    Stretch{c}(box, from, displacement);
    return Row::of({from, displacement}, box);
  });
  add("long_and_thin", [](DrawStream& c) -> Question {
    const Obb3d box = long_and_thin_obb(c);
    const auto& [u, v, w] = box.half_axes;
    const double k = one_to(c, 3);
    const Point3d x = on_obb(box, c);
    switch (c.below(3)) {
      case 0: return Row::of({{-k * u.x, -k * u.y, -k * u.z}, u}, box);
      case 1: return Row::of({{v.x, v.y, v.z}, -k * v}, box);
      default: return Row::of({x, w}, box);
    }
  });
  add("subnormal", [](DrawStream& c) -> Question {
    // Integers times the least number, or a few times that: their products underflow.
    Obb3d box = lattice_obb(c);
    const auto [from, displacement] = course_by_edge(c, box, c.coin());
    const int down = -1074 + integer_in(c, 0, 60);
    change_each(box, [down](auto& v) { v = scaled(v, down); });
    return Row::of({scaled(from, down), scaled(displacement, down)}, box);
  });
  add("moderate_ends", [](DrawStream& c) -> Question {
    // The greatest and the least numbers that enclosures take, and the next beyond them; along a face, or far from it.
    const double large = power_of_two(c, 29, 31), least = power_of_two(c, -32, -29), side = small_integer(c, 1);
    const double far = c.coin() ? 0 : large / 2, y = c.coin() ? least : 0;
    return Row::of({{-large - far, side * large, 0}, {c.coin() ? large : least, -y, 0}},
                   {{0, 0, 0}, {{large, 0, 0}, {0, large, 0}, {0, least, 1}}});
  });
  add("whole_range", [](DrawStream& c) -> Question {
    const Point3d p = point_of_full_range(c), center = point_of_full_range(c);
    const double i = of_full_range(c), j = of_full_range(c), far = of_full_range(c), x = huge(c), y = huge(c);
    return Row::of({p, {i, j, i == 0 && j == 0 ? x : zero(c)}}, {center, {{x, 0, 0}, {far, y, 0}, {0, far, 1}}});
  });
  add("either_zero", [](DrawStream& c) -> Question {
    const Obb3d box{zero_point(c), {{1, zero(c), zero(c)}, {zero(c), -1, zero(c)}, {zero(c), zero(c), 1}}};
    const double x = small_integer(c, 2), y = zero(c), i = small_integer(c, 1), j = zero(c);
    return Row::of({{x == 0 ? zero(c) : x, y, small_integer(c, 1)}, {i, j, i == 0 ? 1 : zero(c)}}, box);
  });
  add("typed_course", [](DrawStream& c) -> Question {
    // As typed it leads along a face of a box that is turned by the triple 3, 4, 5, or to its corner.
    const double k = one_to(c, 9), m = one_to(c, 9), far = small_integer(c, 9);
    const Obb3d box{{0, 0, 0}, {{3 * k / 10, 4 * k / 10, 0}, {-0.8, 0.6, 0}, {0, 0, 1}}};
    const Vector3d along{-4 * m / 10, 3 * m / 10, 0}, diagonal{0.1, 0.2, 0.3};
    return Row::of({{(3 * k - 4 * far) / 10, (4 * k + 3 * far) / 10, 0}, c.coin() ? along : diagonal}, box);
  });
}

}  // namespace touchstone::catalogue
