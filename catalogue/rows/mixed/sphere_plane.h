// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/space_choices.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "oracle/mixed/sphere_plane.h"
#include "reference/mixed/sphere_plane.h"
#include "robust/mixed/sphere_plane.h"

namespace touchstone::catalogue::rows {

struct sphere_plane {
  TOUCHSTONE_MODULES(sphere_plane)
  using stages = ::touchstone::robust::stages::sphere_plane;
  using Question = std::tuple<Sphere3d, Plane3d>;
  using decision = NoDecision;

  static const Card& card() {
    static const Card card{
        .name = "sphere_plane",
        .chapter = "mixed",
        .pages = "22, 44",
        .question = "Do a ball and the half-space N . p + d <= 0 behind a plane overlap, only touch, or neither?",
        .kind = Kind::decision,
        .fields = {"sphere", "plane"},
        .answer = "contact",
        .margin_degree = 2};
    return card;
  }

  static std::vector<HardCase<Question>> hard_cases() {
    return {
        {"tangent",
         [](Choices& c) -> Question {
           const double radius = 1 + static_cast<double>(c.below(6));
           return over_plane(c, radius, radius);
         }},
        {"beside_tangent",
         [](Choices& c) -> Question {
           const double radius = 1 + static_cast<double>(c.below(6)), off = small_integer(c, 1);
           return over_plane(c, radius + off, radius);
         }},
        {"center_behind",
         [](Choices& c) -> Question {
           // As far behind as the radius, or farther, or less.
           const double radius = static_cast<double>(c.below(6)), off = small_integer(c, 1);
           return over_plane(c, -radius - off, radius);
         }},
        {"point_ball",
         [](Choices& c) -> Question {
           const double height = small_integer(c);
           return over_plane(c, height, c.below(2) == 1 ? -0.0 : 0.0);
         }},
        {"least_radius",
         [](Choices& c) -> Question {
           const double radius = std::ldexp(static_cast<double>(1 + c.below(4)), -1074);
           return over_plane(c, small_integer(c), radius);
         }},
        {"irrational",
         [](Choices& c) -> Question {
           const Vector3d n = lattice_normal(c, 10);
           const Point3d p = lattice_point_in_space(c, 10);
           return {{p, static_cast<double>(c.below(12))}, {n, integer(c, 10)}};
         }},
        {"beside_root",
         [](Choices& c) -> Question {
           // x / r is next to the root of 2: x^2 - 2 r^2 is 1 or -1 (Pell).
           double x = 1, r = 1;
           for (auto k = c.below(40); k > 0; --k) x += 2 * r, r = x - r;
           return {{{x, 0, integer(c, 20)}, r}, {{1, c.below(2) == 1 ? -1.0 : 1.0, 0}, 0}};
         }},
        {"rounded_tangent",
         [](Choices& c) -> Question {
           const double nx = ordinary(c), ny = ordinary(c), x = ordinary(c), y = ordinary(c), z = ordinary(c);
           const Vector3d n{nx, ny, 1};
           const double d = ordinary(c), reach = std::fabs(dot(n, Vector3d{x, y, z}) + d) / std::sqrt(dot(n, n));
           return {{{x, y, z}, std::fabs(moved_by_ulps(reach, static_cast<int>(c.below(3)) - 1))}, {n, d}};
         }},
        {"typed_tangent",
         [](Choices& c) -> Question {
           // As typed the ball reaches the plane.
           const double k = 1 + static_cast<double>(c.below(9)), m = 1 + static_cast<double>(c.below(9));
           return {{{0, (m + k) / 10, 0}, k / 10}, {{0, 1, 0}, -m / 10}};
         }},
        {"normal_of_any_size",
         [](Choices& c) -> Question {
           // Past the guards of the squared length, or with parts that count for nothing.
           const int k = static_cast<int>(c.below(2000)) - 1050, m = static_cast<int>(c.below(600)) - 300;
           const double x = small_integer(c), y = small_integer(c), d = small_integer(c), r = small_integer(c, 2);
           const Vector3d n{std::ldexp(1 + small_integer(c, 1) / 4, k), std::ldexp(y, k + m), 0};
           return {{{x, y, 0}, std::fabs(r)}, {n, std::ldexp(d, k)}};
         }},
        {"normal_of_few_digits",
         [](Choices& c) -> Question {
           // Its square is subnormal, and off by more than nothing; the ball touches the plane.
           const int k = static_cast<int>(c.below(24)) - 540;
           const double n = std::ldexp(5 + static_cast<double>(c.below(3)), k), x = 1 + static_cast<double>(c.below(6));
           return {{{x, 0, 0}, x}, {{n, 0, 0}, 0}};
         }},
        {"terms_below_least",
         [](Choices& c) -> Question {
           const auto [plane, center] = terms_below_least(c);
           const double radius = std::ldexp(static_cast<double>(c.below(3)), -1074);
           return {{center, radius}, plane};
         }},
        {"far_beyond_a_lattice",
         [](Choices& c) -> Question {
           // Tangent but for a hair, at sizes within the filter's guards and beyond.
           const double radius = scaled_up(c, 4, 1020), off = small_integer(c, 1);
           const double hair = std::ldexp(off, -static_cast<int>(c.below(1074)));
           return {{{0, c.below(2) == 1 ? -radius : radius, 0}, radius}, {{0, 1, 0}, hair}};
         }},
        {"whole_range",
         [](Choices& c) -> Question {
           // Products overflow, and where nothing does, their sum.
           const double great = std::ldexp(1 + small_integer(c, 1) / 4, 1022), r = c.below(2) == 1 ? great : 1;
           const double y = c.below(2) == 1 ? great : small_integer(c), n = c.below(2) == 1 ? great : 1;
           return {{{great, y, 0}, r}, {{0, n, 0}, c.below(3) == 2 ? -great : small_integer(c, 1)}};
         }},
        {"either_zero",
         [](Choices& c) -> Question {
           const auto zero = [&c] { return c.below(2) == 1 ? -0.0 : 0.0; };
           const double x = zero(), y = zero(), r = zero(), n = zero(), d = zero(), height = small_integer(c, 1);
           return {{{x, c.below(2) == 1 ? height : y, 0}, c.below(2) == 1 ? 1 : r}, {{n, 1, n}, d}};
         }},
        {"zero_normal",
         [](Choices& c) -> Question {
           const Vector3d n{0.0, c.below(2) == 1 ? -0.0 : 0.0, 0.0};
           return {{lattice_point_in_space(c), 1}, {n, small_integer(c)}};
         }},
    };
  }

  /// The normal has no unit: it keeps its value.
  static void scale(Question& question, int k) {
    auto& [sphere, plane] = question;
    for (double* length : {&sphere.center.x, &sphere.center.y, &sphere.center.z, &sphere.radius, &plane.offset})
      *length = std::ldexp(*length, k);
  }

  static void repair(Question& question) {
    double& radius = std::get<0>(question).radius;
    radius = std::fabs(radius);
  }

  /// It just reaches the plane x + 2y + 2z = 9: moves x and y of the center.
  static Question map_centre() { return {{{3, 6, 6}, 6}, {{1, 2, 2}, -9}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<sphere_plane> hooks() {
    return {.as_open_sets = disjoint_if_touching<Question>,
            .repair = repair,
            .scale = scale,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }

 private:
  /// Height of the center and radius in units of the length of the normal; the plane goes through a lattice point.
  static Question over_plane(Choices& c, double height, double radius) {
    const auto [n, length] = whole_normal(c);
    const Point3d foot = lattice_point_in_space(c, 10), center = foot + (lattice_across(c, n) + height * n);
    return {{center, radius * length}, {n, -dot(n, Vector3d{foot.x, foot.y, foot.z})}};
  }
};

}  // namespace touchstone::catalogue::rows
