// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/box_draws.h"
#include "catalogue/families/whole_steps.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/volumes/sphere_aabb.h"
#include "oracle/volumes/sphere_aabb.h"
#include "reference/volumes/sphere_aabb.h"
#include "robust/batch/sphere_aabb.h"
#include "robust/volumes/sphere_aabb.h"

namespace touchstone::catalogue::rows {

struct sphere_aabb : signatures::sphere_aabb {
  TOUCHSTONE_STAGED_MODULES(sphere_aabb)
  TOUCHSTONE_ARRAYS(sphere_aabb)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "volumes",
      .pages = "48-50",
      .question = "Do the ball, or disc, and the axis-aligned box overlap, only touch, or neither?",
      .kind = Kind::decision,
      .fields = {"sphere", "aabb"},
      .answer = "contact",
      .margin_degree = 2};

  static void hard_cases(HardCases<Question>& add) {
    add("tangent", [](DrawStream& c) -> Question {
      const Step step = integer_step(c);
      return beyond(step, step.length, c);
    });
    add("beside_tangent", [](DrawStream& c) -> Question {
      const Step step = integer_step(c);
      return beyond(step, std::max(step.length + small_integer(c, 1), 0.0), c);
    });
    add("point_ball", [](DrawStream& c) -> Question {
      // In the box, on its boundary, or near it.
      const Aabb3d box = lattice_box(c);
      const Point3d p = within(box, c).min;
      const double aside = small_integer(c, 1), r = zero(c);
      return seen({{p.x + aside, p.y, p.z}, r}, box, c.coin());
    });
    add("center_inside", [](DrawStream& c) -> Question {
      const Aabb3d box = lattice_box(c);
      const Point3d p = within(box, c).max;
      const auto r = up_to(c, 3);
      return seen({p, r}, box, c.coin());
    });
    add("flat", [](DrawStream& c) -> Question {
      // A rectangle, a segment or a point: next to the ball, tangent to it or in it.
      const Step step = integer_step(c);
      auto [ball, box] = in_space(step, std::max(step.length + small_integer(c, 1), 0.0), c);
      box.max.x = box.min.x;
      if (c.coin()) box.max.y = box.min.y;
      if (c.coin()) box.max.z = box.min.z;
      return seen(ball, box, step.in_plane);
    });
    add("long_tangent", [](DrawStream& c) -> Question {
      // A multiple of 3, 4, 5 whose squares do not fit a double.
      const double w = 0x1p49 + static_cast<double>(c.below(std::uint64_t{1} << 49));
      const double side = either_sign(c), less = small_integer(c, 1);
      const Aabb3d box{{-1, -1, -1}, {0, 0, 1}};
      return seen({{3 * w, side < 0 ? -1 - 4 * w : 4 * w, 0}, 5 * w + less}, box, c.coin());
    });
    add("far_below", [](DrawStream& c) -> Question {
      // Tangent to a face, the radius as large as the lattice just holds next to the box, or larger; the box aside
      // by a hair, or the ball.
      const double large = power_of_two(c, 50, 69),
                   larger = c.coin() ? std::ldexp(large, integer_in(c, 0, 899)) : large;
      const double side = small_integer(c, 1), hair = std::ldexp(side, -integer_in(c, 0, 1073));
      const double off = c.coin() ? hair : 0.0;
      return seen({{-larger, 0, 0}, larger}, {{off, hair - 1, -1}, {1, hair, 1}}, c.coin());
    });
    add("rounded_tangent", [](DrawStream& c) -> Question {
      const double x = ordinary(c), y = ordinary(c), z = ordinary(c), dx = ordinary(c), dy = ordinary(c);
      const Point3d corner{x, y, z};
      const Vector3d displacement{std::fabs(dx), std::fabs(dy), c.coin() ? std::fabs(ordinary(c)) : 0.0};
      const double r = moved_by_ulps(std::sqrt(dot(displacement, displacement)), integer_in(c, -3, 3));
      return seen({corner + displacement, std::fabs(r)}, {{x - 1, y - 1, z - 1}, corner}, c.coin());
    });
    add("much_rounded", [](DrawStream& c) -> Question {
      // A difference just above a power of two less a small number, and a radius like it: both round by all they
      // may.
      const auto large = [&c] { return 1 + up_to(c, 2) * 0x1p-52; };
      const double x = large(), r = large(), y = up_to(c, 255) * 0x1p-60;
      const int e = integer_in(c, -300, 300);
      const double from = std::ldexp(either_sign(c) * y, e);
      return seen({{std::ldexp(x, e), 0, 0}, std::ldexp(r, e)}, {{-std::ldexp(1, e), -1, -1}, {from, 1, 1}}, c.coin());
    });
    add("squares_underflow", [](DrawStream& c) -> Question {
      const Step step = integer_step(c);
      const double r = std::max(step.length + small_integer(c, 1), 0.0);
      Question question = beyond(step, r, c);
      const int down = integer_in(c, 530, 561);
      for_each_number(question, [down](double& x) { x = std::ldexp(x, -down); });
      return question;
    });
    add("subnormal", [](DrawStream& c) -> Question {
      // Near the least normal number, and at the origin.
      const auto least = [&c] { return std::ldexp(up_to(c, 5), -1074); };
      const double from = c.coin() ? 0x1p-1021 : 0.0, x = least(), y = least(), r = least(), s = least(), t = least();
      return seen({{from + x, y, 0}, r}, {{from - s, -t, -0.0}, {from, s, t}}, c.coin());
    });
    add("either_zero", [](DrawStream& c) -> Question {
      const double x = zero(c), y = zero(c), r = zero(c), z0 = zero(c), z1 = zero(c);
      const double more = up_to(c, 1), end = c.coin() ? zero(c) : 1.0, top = zero(c);
      return seen({{x, y, z0}, more == 0 ? r : more}, {{z1, z0, -1}, {end, 1, top}}, c.coin());
    });
    add("whole_range", [](DrawStream& c) -> Question {
      const double r = c.coin() ? greatest_double : std::ldexp(one_to(c, 2), 1022);
      const double x = c.coin() ? -greatest_double : -0x1p1023, y = c.coin() ? 0.0 : 0x1p1022;
      const double aside = small_integer(c, 1), end = c.coin() ? greatest_double : 1;
      return seen({{x, y, 0}, r}, {{aside, -end, -end}, {end, end, end}}, c.coin());
    });
    add("typed_touch", [](DrawStream& c) -> Question {
      // As typed the ball reaches the corner.
      const double k = one_to(c, 9), m = one_to(c, 9);
      return seen({{(m + 3 * k) / 10, (m + 4 * k) / 10, 0}, 5 * k / 10}, {{-1, -1, -1}, {m / 10, m / 10, 1}}, c.coin());
    });
    add("wide", [](DrawStream& c) -> Question {
      const Step step = integer_step(c);
      const double r = std::max(step.length + std::ldexp(small_integer(c, 1), -20), 0.0);
      auto [ball, box] = in_space(step, r, c);
      const Vector3d by = fractions(c);
      ball.center = ball.center + by, box = shifted(box, by.x, by.y, by.z);
      return seen(ball, widened(box, ball.center, c), step.in_plane);
    });
  }

  /// The radius loses its sign.
  static void repair(Question& question) {
    std::visit(
        [](auto& solids) {
          auto& [sphere, aabb] = solids;
          sphere.radius = std::fabs(sphere.radius), put_in_order(aabb);
        },
        question);
  }

  /// A disc that reaches the corner (12, 12) by the triple 3, 4, 5; moves its center.
  static Question map_centre() { return InPlane{{{15, 16}, 5}, {{0.5, 0.5}, {12, 12}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<sphere_aabb> hooks() {
    return {.as_open_sets = disjoint_if_touching<Question>,
            .repair = repair,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }

 private:
  /// A ball whose center is beyond a box by a step: beyond a face, an edge or a corner, as the step has one, two or
  /// three coordinates that are not 0.
  static InSpace in_space(const Step& step, double radius, DrawStream& c) {
    const Aabb3d box = lattice_box(c);
    const Point3d inside = within(box, c).min;
    const auto coordinate = [&c](double displacement, double min, double max, double beside) {
      if (displacement == 0) return beside;
      return c.coin() ? min - std::fabs(displacement) : max + std::fabs(displacement);
    };
    const double x = coordinate(step.displacement.x, box.min.x, box.max.x, inside.x),
                 y = coordinate(step.displacement.y, box.min.y, box.max.y, inside.y),
                 z = coordinate(step.displacement.z, box.min.z, box.max.z, inside.z);
    return {{{x, y, z}, radius}, box};
  }
  static Question beyond(const Step& step, double radius, DrawStream& c) {
    const auto [ball, box] = in_space(step, radius, c);
    return seen(ball, box, step.in_plane);
  }
  static Question seen(const Sphere3d& ball, const Aabb3d& box, bool in_plane) {
    if (!in_plane) return InSpace{ball, box};
    return InPlane{{{ball.center.x, ball.center.y}, ball.radius}, without_z(box)};
  }
};

}  // namespace touchstone::catalogue::rows
