// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/space_draws.h"
#include "catalogue/families/ties.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/sweeps/swept_sphere_plane.h"
#include "oracle/sweeps/swept_sphere_plane.h"
#include "reference/sweeps/swept_sphere_plane.h"
#include "robust/sweeps/swept_sphere_plane.h"

namespace touchstone::catalogue::rows {

struct swept_sphere_plane : signatures::swept_sphere_plane {
  TOUCHSTONE_STAGED_MODULES(swept_sphere_plane)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "sweeps",
      .pages = "22-23, 51",
      .question = "When in a step does a moving ball first have a common point with a plane?",
      .kind = Kind::measure,
      .fields = {"sphere", "velocity", "plane"},
      .ulps = 20,
      .margin_degree = 2};

  static void hard_cases(HardCases<Question>& add) {
    add("approach", [](DrawStream& c) -> Question {
      const double radius = up_to(c, 5), gap = one_to(c, 8);
      return of_integer_length(c, radius + gap, radius, gap + small_integer(c));
    });
    add("touching_at_start", [](DrawStream& c) -> Question {
      const double radius = up_to(c, 5);
      return of_integer_length(c, radius, radius, small_integer(c));
    });
    add("contact_at_end", [](DrawStream& c) -> Question {
      const double radius = up_to(c, 5), gap = one_to(c, 8);
      return of_integer_length(c, radius + gap, radius, gap);
    });
    add("overlaps_at_start", [](DrawStream& c) -> Question {
      const double radius = one_to(c, 6), aside = small_integer(c);
      return of_integer_length(c, static_cast<double>(c.below(static_cast<std::uint64_t>(radius))), radius, aside);
    });
    add("along_plane", [](DrawStream& c) -> Question {
      const double radius = up_to(c, 5), off = small_integer(c, 1);
      return of_integer_length(c, radius + off, radius, 0);
    });
    add("points", [](DrawStream& c) -> Question {
      const double height = up_to(c, 3);
      return of_integer_length(c, height, 0, small_integer(c, 6));
    });
    add("irrational", [](DrawStream& c) -> Question {
      const Vector3d n = lattice_normal(c, 10), v = lattice_normal(c, 10);
      return {{lattice_point_in_space(c, 10), up_to(c, 11)}, v, {n, integer(c, 10)}};
    });
    add("rounded_touch", [](DrawStream& c) -> Question {
      // A touch at the start or at the end, as far as doubles can tell.
      const Vector3d n{ordinary(c), ordinary(c), 1}, p{ordinary(c), ordinary(c), ordinary(c)};
      const double d = ordinary(c);
      const Vector3d v{ordinary(c), ordinary(c), ordinary(c)}, at = c.coin() ? p + v : p;
      return {{{p.x, p.y, p.z}, within_ulps(c, std::fabs(dot(n, at) + d) / std::sqrt(dot(n, n)), 1)}, v, {n, d}};
    });
    add("beside_a_tie", [](DrawStream& c) -> Question {
      const auto [low, high, fall] = way_beside_tie(c);
      return {{{0, high, 0}, 0}, {0, -fall * 0x1p54, 0}, {{0, 1, 0}, low}};
    });
    add("uneven_normal", [](DrawStream& c) -> Question {
      // Past the guards of the squared length, or with parts that count for nothing.
      const int k = integer_in(c, -1050, 949), m = integer_in(c, -300, 299);
      const double x = small_integer(c), y = small_integer(c), d = small_integer(c), r = small_integer(c, 2);
      const Vector3d n{std::ldexp(1 + small_integer(c, 1) / 4, k), std::ldexp(y, k + m), 0};
      return {{{x, y, 0}, std::fabs(r)}, {-2 * x, small_integer(c), 0}, {n, std::ldexp(d, k)}};
    });
    add("normal_of_few_digits", [](DrawStream& c) -> Question {
      // Its square is subnormal, and off by more than nothing; the ball touches the plane at the start.
      const int k = integer_in(c, -540, -517);
      const double n = std::ldexp(5 + up_to(c, 2), k), x = one_to(c, 6);
      return {{{x, 0, 0}, x}, {small_integer(c), 0, 0}, {{n, 0, 0}, 0}};
    });
    add("least_beside_greatest", [](DrawStream& c) -> Question {
      const double least = subnormal(c), greatest = huge(c);
      const double d = c.coin() ? least : -greatest, y = c.coin() ? greatest : 4, r = c.coin() ? std::fabs(least) : 1;
      return {{{0, y, least}, r}, {0, -y, least}, {{0, 1, c.coin() ? 1.0 : least}, d}};
    });
    add("starts_below_least", [](DrawStream& c) -> Question {
      const auto [plane, start] = terms_below_least(c);
      return {{start, 0}, {small_integer(c, 1), 1, -1}, plane};
    });
    add("either_zero", [](DrawStream& c) -> Question {
      const double x = zero(c), y = zero(c), r = zero(c), v = zero(c), n = zero(c), d = zero(c);
      return {{{x, c.coin() ? 1 : y, 0}, r}, {v, small_integer(c, 1), 0}, {{n, 1, 0}, d}};
    });
  }

  /// The normal has no unit: it keeps its value.
  static void scale(Question& question, int k) {
    auto& [sphere, velocity, plane] = question;
    for (double* length : {&sphere.center.x, &sphere.center.y, &sphere.center.z, &sphere.radius, &velocity.x,
                           &velocity.y, &velocity.z, &plane.offset})
      *length = std::ldexp(*length, k);
  }

  static void repair(Question& question) {
    double& radius = std::get<0>(question).radius;
    radius = std::fabs(radius);
  }

  /// It just gets to the plane x + 2y + 2z = 0: moves y and z of the velocity.
  static Question map_centre() { return {{{3, 6, 6}, 6}, {-1, -2, -2}, {{1, 2, 2}, 0}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {5, 6}; }

  /// The step: the ball at its start, at the first contact and at its end.
  static void draw(Drawing& drawing, const Question& question, const FirstContact<double>& truth) {
    const auto& [sphere, velocity, plane] = question;
    draw_sweep(drawing, "sphere", sphere, velocity, truth.t);
    ::touchstone::catalogue::draw(drawing, "plane", plane, false);
  }

  static Hooks<swept_sphere_plane> hooks() {
    return {.as_open_sets = never_if_grazing<swept_sphere_plane>,
            .repair = repair,
            .scale = scale,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .draw = draw};
  }

 private:
  /// Height of the center, radius and fall of a step in units of the length of a normal that is an integer; the
  /// plane goes through a lattice point; seen from either side.
  static Question of_integer_length(DrawStream& c, double height, double radius, double fall) {
    const auto [n, length] = integer_normal(c);
    const Point3d foot = lattice_point_in_space(c, 10);
    const Vector3d aside = lattice_across(c, n), drift = lattice_across(c, n);
    const double side = either_sign(c);
    const Point3d center = foot + (aside + (side * height) * n);
    return {{center, radius * length}, drift - (side * fall) * n, {n, -dot(n, Vector3d{foot.x, foot.y, foot.z})}};
  }
};

}  // namespace touchstone::catalogue::rows
