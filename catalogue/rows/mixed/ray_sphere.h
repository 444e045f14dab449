// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/passages/line_ball_cases.h"
#include "catalogue/families/passages/tight_tangents.h"
#include "catalogue/operation/open_passages.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/ray_sphere.h"
#include "oracle/mixed/ray_sphere.h"
#include "reference/mixed/ray_sphere.h"
#include "reference/standard/roots_of_sphere.h"
#include "robust/mixed/ray_sphere.h"

namespace touchstone::catalogue::rows {

struct ray_sphere : signatures::ray_sphere {
  TOUCHSTONE_STAGED_MODULES(ray_sphere)

  struct decision {
    static PassageRelation robust(const Question& question) {
      return applied([](const auto&... q) { return ::touchstone::robust::ray_sphere_relation(q...); }, question);
    }
  };

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "mixed",
                                     .pages = "9, 23",
                                     .question = "Where does the ray enter and leave the ball, or disc?",
                                     .kind = Kind::measure,
                                     .fields = {"ray", "sphere"},
                                     .ulps = 24,
                                     .margin_degree = 2};

  static Question of(const Course& course, const Sphere3d& ball, bool in_plane) {
    const auto& [p, v] = course;
    if (in_plane && (v.x != 0 || v.y != 0))
      return InPlane{{{p.x, p.y}, {v.x, v.y}}, {{ball.center.x, ball.center.y}, ball.radius}};
    return InSpace{{p, v}, ball};
  }
  static bool has_interior(const Circle2d& disc) { return disc.radius > 0; }
  static bool has_interior(const Sphere3d& ball) { return ball.radius > 0; }

  static void standard(const auto& add) {
    add("half the linear coefficient", [](const auto&... q) {
      return ::touchstone::reference::standard::ray_sphere<::touchstone::reference::standard::ByHalfCoefficient>(q...);
    });
    add("unit direction", [](const auto&... q) {
      return ::touchstone::reference::standard::ray_sphere<::touchstone::reference::standard::ByUnitDirection>(q...);
    });
  }

  static void hard_cases(HardCases<Question>& add) {
    line_ball_cases<ray_sphere>(add);
    add("tangent_of_all_digits", [](DrawStream& c) -> Question {
      const auto [p, v, ball] = tight_tangent(c);
      return of({p, v}, ball, p.z == 0 && v.z == 0);
    });
  }

  static void repair(Question& question) {
    std::visit([](auto& q) { std::get<1>(q).radius = std::fabs(std::get<1>(q).radius); }, question);
  }

  /// Tangent to a disc; moves the direction.
  static Question map_centre() { return InPlane{{{1, 5}, {1, 0}}, {{16, 16}, 11}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {2, 3}; }

  static Hooks<ray_sphere> hooks() {
    return {.as_open_sets = none_if_grazing<ray_sphere>,
            .repair = repair,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::similarities, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
