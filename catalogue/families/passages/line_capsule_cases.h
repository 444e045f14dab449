// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/closest_draws.h"
#include "catalogue/families/passages/line_solid_cases.h"
#include "catalogue/families/ties.h"
#include "geometry/capsules.h"

/// Families of a line and a capsule. Row::of(course, capsule): the question whose line has that course.
namespace touchstone::catalogue {

/// A capsule, or a ball; a point of its axis, an end of it, or a point beyond; a place near that, which is as far from
/// the axis as the radius, or a little more or less; and a direction at right angles to the way there.
struct BesideCapsule {
  Capsule3d capsule;
  Point3d foot, place;
  Vector3d axis, across;

  static BesideCapsule of(DrawStream& c) {
    const auto [out, u, v, length] = IntegerAcross::of(c);
    const Point3d a = lattice_point_in_space(c, 12);
    const double radius = reaching(c, length), parts = c.coin() ? 2 : up_to(c, 1);
    const Point3d foot = along(a, 1 + small_integer(c, 2), u);
    return {{{a, along(a, parts, u)}, radius}, foot, foot + out, u, zero(v) ? cross(out, u) : v};
  }

  static bool zero(const Vector3d& v) { return v.x == 0 && v.y == 0 && v.z == 0; }
};

template <class Row>
void line_capsule_cases(HardCases<typename Row::Question>& add) {
  using Question = typename Row::Question;
  add("tangent", [](DrawStream& c) -> Question {
    const auto [capsule, foot, place, axis, across] = BesideCapsule::of(c);
    return Row::of(course_through(c, place, across), capsule);
  });
  add("along_axis", [](DrawStream& c) -> Question {
    // Along the axis itself, or next to it.
    const auto [capsule, foot, place, axis, across] = BesideCapsule::of(c);
    const double side = either_sign(c);
    return Row::of(course_through(c, c.coin() ? foot : place, side * axis), capsule);
  });
  add("through_side", [](DrawStream& c) -> Question {
    // Where the cylinder and the ball meet, if the foot is an end.
    const auto [capsule, foot, place, axis, across] = BesideCapsule::of(c);
    return Row::of(course_through(c, place, lattice_normal(c, 6)), capsule);
  });
  add("through_axis", [](DrawStream& c) -> Question {
    const auto [capsule, foot, place, axis, across] = BesideCapsule::of(c);
    const Vector3d v = lattice_normal(c, 4);
    return Row::of(course_through(c, foot, c.coin() ? power_of_two(c, 4, 20) * axis + v : v), capsule);
  });
  add("starts_on_side", [](DrawStream& c) -> Question {
    const auto [capsule, foot, place, axis, across] = BesideCapsule::of(c);
    return Row::of({place, c.coin() ? across : lattice_normal(c, 6)}, capsule);
  });
  add("starts_inside", [](DrawStream& c) -> Question {
    const auto [capsule, foot, place, axis, across] = BesideCapsule::of(c);
    return Row::of({foot, c.coin() ? axis : lattice_normal(c, 12)}, capsule);
  });
  add("aimed", [](DrawStream& c) -> Question {
    const Point3d a = lattice_point_in_space(c, 6), b = lattice_point_in_space(c, 6);
    const Capsule3d capsule{{a, b}, up_to(c, 11)};
    const bool from_a = c.coin();
    const Point3d x = beside(from_a ? a : b, c, 3);
    return Row::of(course_through(c, x, lattice_normal(c, 6)), capsule);
  });
  add("no_radius", [](DrawStream& c) -> Question {
    // It passes through the segment, or its line, or along it, or misses it.
    auto [capsule, foot, place, axis, across] = BesideCapsule::of(c);
    capsule.radius = zero(c);
    const Point3d x{foot.x, foot.y, foot.z + small_integer(c, 1)};
    return Row::of(course_through(c, x, c.coin() ? lattice_normal(c, 6) : axis), capsule);
  });
  add("no_length", [](DrawStream& c) -> Question {
    const auto [capsule, foot, place, axis, across] = BesideCapsule::of(c);
    return Row::of({place, {0, -0.0, 0}}, capsule);
  });
  add("from_far_away", [](DrawStream& c) -> Question {
    const auto [capsule, foot, place, axis, across] = BesideCapsule::of(c);
    return Row::of(course_from_afar(c, place, c.coin() ? lattice_normal(c, 3) : across), capsule);
  });
  add("direction_of_any_size", [](DrawStream& c) -> Question {
    const auto [capsule, foot, place, axis, across] = BesideCapsule::of(c);
    const auto [from, displacement] = course_through(c, foot, lattice_normal(c, 4));
    return Row::of({from, of_any_size(c, displacement)}, capsule);
  });
  add("rounded_tangent", [](DrawStream& c) -> Question {
    // As far as doubles can tell it grazes the cylinder, or an end's ball.
    const Point3d a = ordinary_point_in_space(c), b = ordinary_point_in_space(c), x = ordinary_point_in_space(c);
    const Vector3d v = ordinary_point_in_space(c) - Point3d{0, 0, 0}, out = cross(v, c.coin() ? b - a : x - a);
    const double share = c.coin() ? 0 : 0.5, radius = near_length(c, out);
    return Row::of(course_through(c, along(a, share, b - a) + out, v), {{a, b}, radius});
  });
  add("beside_a_tie", [](DrawStream& c) -> Question {
    // The entry into the cylinder, in units of 2^-54.
    const auto [low, high, speed] = way_beside_tie(c);
    const double x = high + 0x1p32;
    return Row::of({{-low, 0, 0}, {speed * 0x1p54, 0, 0}}, {{{x, -1, 0}, {x, 1, 0}}, 0x1p32});
  });
  add("halfway", [](DrawStream& c) -> Question {
    // Within the numbers that enclosures take: the way in is an odd integer of 54 digits, in units of 2^-24.
    const double x = 0x1p29 + up_to(c, 1000) * 0x1p-23 + 1, size = power_of_two(c, 0, 30), y = small_integer(c, 1);
    return Row::of({{-0x1p-24, y, 0}, {size, 0, 0}}, {{{x, -2, 0}, {x, 2, 0}}, 1});
  });
  add("stretched", [](DrawStream& c) -> Question {
    auto [capsule, foot, place, axis, across] = BesideCapsule::of(c);
    auto [from, displacement] = course_through(c, foot, lattice_normal(c, 4));
    Stretch{c}(capsule.segment.a, capsule.segment.b, from, displacement);
    return Row::of({from, displacement}, capsule);
  });
  add("subnormal", [](DrawStream& c) -> Question {
    // Integers times the least number, or a few times that: their products underflow.
    const auto [capsule, foot, place, axis, across] = BesideCapsule::of(c);
    const auto [from, displacement] = course_through(c, place, c.coin() ? across : lattice_normal(c, 4));
    const int down = -1074 + integer_in(c, 0, 60);
    const auto& [a, b] = capsule.segment;
    return Row::of({scaled(from, down), scaled(displacement, down)},
                   {{scaled(a, down), scaled(b, down)}, std::ldexp(capsule.radius, down)});
  });
  add("moderate_ends", [](DrawStream& c) -> Question {
    // The greatest and the least numbers that enclosures take, and the next beyond them; along the side, or far from
    // it.
    const double large = power_of_two(c, 29, 31), least = power_of_two(c, -32, -29), side = small_integer(c, 1);
    const double far = c.coin() ? 0 : large / 2, r = c.coin() ? least : large;
    return Row::of({{-large - far, side * r, 0}, {c.coin() ? large : least, c.coin() ? least : 0.0, 0}},
                   {{{-large, 0, 0}, {large, least, 0}}, r});
  });
  add("whole_range", [](DrawStream& c) -> Question {
    const Point3d p = point_of_full_range(c), a = point_of_full_range(c), b = point_of_full_range(c);
    const double i = of_full_range(c), j = of_full_range(c), r = std::fabs(of_full_range(c)), x = huge(c);
    return Row::of({p, {i, j, i == 0 && j == 0 ? x : zero(c)}}, {{a, b}, r});
  });
  add("either_zero", [](DrawStream& c) -> Question {
    const Point3d a = zero_point(c), b = zero_point(c);
    const double x = small_integer(c, 2), y = zero(c), i = small_integer(c, 1), j = zero(c);
    const Capsule3d capsule{{a, c.coin() ? b : Point3d{1, 0, 0}}, zero(c)};
    return Row::of({{x == 0 ? zero(c) : x, y, small_integer(c, 1)}, {i, j, i == 0 ? 1 : zero(c)}}, capsule);
  });
  add("typed_course", [](DrawStream& c) -> Question {
    // As typed it leads along the cylinder around an axis in the direction (3, 4), or to its end.
    const double k = one_to(c, 9), m = one_to(c, 9), far = small_integer(c, 9);
    const Capsule3d capsule{{{0, 0, 0}, {3 * m / 10, 4 * m / 10, 0}}, 5 * k / 10};
    const Vector3d along{0.3, 0.4, 0}, diagonal{0.1, 0.2, 0.3};
    return Row::of({{(-4 * k - 3 * far) / 10, (3 * k - 4 * far) / 10, 0}, c.coin() ? along : diagonal}, capsule);
  });
}

}  // namespace touchstone::catalogue
