// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "catalogue/draw/motions.h"
#include "catalogue/families/space_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/sweeps/swept_sphere_sphere.h"
#include "oracle/sweeps/swept_sphere_sphere.h"
#include "reference/sweeps/swept_sphere_sphere.h"
#include "robust/sweeps/swept_sphere_sphere.h"

namespace touchstone::catalogue::rows {

struct swept_sphere_sphere : signatures::swept_sphere_sphere {
  TOUCHSTONE_STAGED_MODULES(swept_sphere_sphere)

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "sweeps",
                                     .pages = "23, 51",
                                     .question = "When in a step do two moving balls first have a common point?",
                                     .kind = Kind::measure,
                                     .fields = {"a", "b", "velocity_a", "velocity_b"},
                                     .ulps = 30,
                                     .margin_degree = 2};

  struct decision {
    static HitRelation robust(const Question& q) {
      return applied([](const auto&... value) { return ::touchstone::robust::swept_sphere_sphere_relation(value...); },
                     q);
    }
  };

  static void hard_cases(HardCases<Question>& add) {
    add("tangent", [](DrawStream& c) -> Question {
      // A line at the distance of the radii from the origin, by a Pythagorean triple.
      static constexpr std::array<std::array<double, 3>, 4> triples{{{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {7, 24, 25}}};
      const auto [m, n, r] = triples[c.below(4)];
      const double s = one_to(c, 8), f = one_to(c, 16), k = up_to(c, 19);
      const Vector3d along{-n, m, small_integer(c, 4)}, p = Vector3d{m * s, n * s, 0} + k * along;
      return common_motion(p, -f * along, r * s, c);
    });
    add("touching_at_start", [](DrawStream& c) -> Question {
      const auto [p, r] = hypotenuse(c);
      return common_motion(p, lattice_normal(c, 4), r, c);
    });
    add("contact_at_end", [](DrawStream& c) -> Question {
      const auto [p, r] = hypotenuse(c);
      const Vector3d v = lattice_normal(c, 4);
      return common_motion(p - v, v, r, c);
    });
    add("head_on", [](DrawStream& c) -> Question {
      const double gap = one_to(c, 8), speed = one_to(c, 16), reach = up_to(c, 5);
      return common_motion({-gap - reach, 0, 0}, {speed, 0, 0}, reach, c);
    });
    add("aimed", [](DrawStream& c) -> Question {
      const Vector3d p = lattice_normal(c, 6), v = -one_to(c, 2) * p;
      const Vector3d aside{small_integer(c, 2), small_integer(c, 2), small_integer(c, 2)};
      return common_motion(p, v + aside, up_to(c, 11), c);
    });
    add("same_velocity", [](DrawStream& c) -> Question {
      const Vector3d p = lattice_normal(c, 4);
      return common_motion(p, {0, 0, 0}, up_to(c, 15), c);
    });
    add("points", [](DrawStream& c) -> Question {
      const Vector3d p = lattice_normal(c, 8);
      return common_motion(p, -up_to(c, 2) * p, 0, c);
    });
    add("one_inside", [](DrawStream& c) -> Question {
      const Vector3d p = lattice_normal(c, 4), v = lattice_normal(c, 6);
      return common_motion(p, v, 64 + up_to(c, 7), c);
    });
    add("fast", [](DrawStream& c) -> Question {
      // Velocities that cancel but for a little.
      const Vector3d p = lattice_normal(c, 4), v = lattice_normal(c, 3);
      Question question = common_motion(p, v, up_to(c, 5), c);
      const double size = power_of_two(c, 30, 52);
      auto& [a, b, va, vb] = question;
      va.x += size, vb.x += size;
      return question;
    });
    add("rounded_tangent", [](DrawStream& c) -> Question {
      const Vector3d p = in_tenths(c), v = in_tenths(c);
      // A touch at the start, at the nearest point of the passage, or at the end, as far as doubles can tell.
      const Vector3d end = p + v, area = cross(p, v);
      const double speed = std::sqrt(dot(v, v));
      double reach = std::sqrt(dot(p, p));
      switch (c.below(3)) {
        case 0: break;
        case 1: reach = speed > 0 ? std::sqrt(dot(area, area)) / speed : reach; break;
        default: reach = std::sqrt(dot(end, end));
      }
      return {{{p.x, p.y, p.z}, within_ulps(c, reach, 1)}, {{0, 0, 0}, 0}, v, {0, 0, 0}};
    });
    add("rounded_touch", [](DrawStream& c) -> Question {
      // The reach is the distance at the start or at the end, rounded.
      const Vector3d p = in_tenths(c), v = in_tenths(c), end = p + v, touch = c.coin() ? end : p;
      return {{{p.x, p.y, p.z}, std::sqrt(dot(touch, touch))}, {{0, 0, 0}, 0}, v, {0, 0, 0}};
    });
    add("least_beside_greatest", [](DrawStream& c) -> Question {
      const double tiny = subnormal(c), large = huge(c);
      const Vector3d v = c.coin() ? Vector3d{-large, 0, 0} : Vector3d{-4, tiny, 0};
      return {{{c.coin() ? large : 3.0, tiny, 0}, 1}, {{0, 0, 0}, c.coin() ? 1.0 : std::fabs(tiny)}, v, {0, 0, 0}};
    });
    add("either_zero", [](DrawStream& c) -> Question {
      const double x = zero(c), r = zero(c), s = zero(c), v = zero(c);
      return {{{x, small_integer(c, 1), 0}, r}, {{0, 0, 0}, s}, {v, small_integer(c, 1), 0}, {0, 0, 0}};
    });
    add("one_stands", [](DrawStream& c) -> Question {
      // The other comes from close by, or from afar, mostly fast.
      const Point3d at = lattice_point_in_space(c, 3);
      const Vector3d p = lattice_normal(c, 6), aside = lattice_normal(c, 2), v = -one_to(c, 1000) * p + aside;
      const double radius = up_to(c, 2), length = std::floor(std::sqrt(dot(p, p))) + small_integer(c, 1);
      const Sphere3d stands{at, radius}, comes{at + p, std::fabs(length - radius)};
      if (!c.coin()) return {stands, comes, {0, 0, 0}, v};
      return {comes, stands, v, {0, 0, 0}};
    });
  }

  /// Lengths and velocities alike: t stays. Radii lose their sign.
  static void repair(Question& question) {
    auto& [a, b, va, vb] = question;
    a.radius = std::fabs(a.radius), b.radius = std::fabs(b.radius);
  }

  /// A tangent sweep: moves the radius and the height of the first ball.
  static Question map_centre() { return {{{-12, 5, 0}, 2}, {{0, 0, 0}, 3}, {24, 0, 0}, {0, 0, 0}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {1, 3}; }

  /// The step: each ball at its start, at the first contact and at its end.
  static void draw(Drawing& drawing, const Question& question, const FirstContact<double>& truth) {
    const auto& [a, b, velocity_a, velocity_b] = question;
    draw_sweep(drawing, "a", a, velocity_a, truth.t), draw_sweep(drawing, "b", b, velocity_b, truth.t);
  }

  static Hooks<swept_sphere_sphere> hooks() {
    return {.as_open_sets = never_if_grazing<swept_sphere_sphere>,
            .repair = repair,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .draw = draw,
            .laws = {.maps = Laws::Maps::similarities, .scales = true}};
  }

 private:
  static Vector3d in_tenths(DrawStream& c) {
    return {small_integer(c, 40) / 10, small_integer(c, 40) / 10, small_integer(c, 40) / 10};
  }

  /// A vector of integer length, and that length.
  static std::pair<Vector3d, double> hypotenuse(DrawStream& c) {
    static constexpr std::array<std::array<double, 4>, 5> quadruples{
        {{1, 2, 2, 3}, {3, 4, 0, 5}, {2, 3, 6, 7}, {1, 4, 8, 9}, {4, 4, 7, 9}}};
    const auto [x, y, z, r] = quadruples[c.below(5)];
    const double s = one_to(c, 8), sign = either_sign(c);
    return {{sign * x * s, y * s, z * s}, r * s};
  }

  /// p, v and reach are what b sees of a: both moved by one lattice vector, both with one more velocity, the reach
  /// dealt out.
  static Question common_motion(const Vector3d& p, const Vector3d& v, double reach, DrawStream& c) {
    const Point3d at = lattice_point_in_space(c, 6);
    const Vector3d common{small_integer(c, 2), small_integer(c, 2), small_integer(c, 2)};
    const double radius = static_cast<double>(c.below(static_cast<std::uint64_t>(reach) + 1));
    const Sphere3d a{at + p, reach - radius}, b{at, radius};
    if (!c.coin()) return {a, b, v + common, common};
    return {b, a, common, v + common};
  }
};

}  // namespace touchstone::catalogue::rows
