// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/passages/line_ball_cases.h"
#include "catalogue/operation/open_passages.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/segment_sphere.h"
#include "oracle/mixed/segment_sphere.h"
#include "reference/mixed/segment_sphere.h"
#include "reference/standard/roots_of_sphere.h"
#include "robust/mixed/segment_sphere.h"

namespace touchstone::catalogue::rows {

struct segment_sphere : signatures::segment_sphere {
  TOUCHSTONE_STAGED_MODULES(segment_sphere)

  struct decision {
    static PassageRelation robust(const Question& question) {
      return applied([](const auto&... q) { return ::touchstone::robust::segment_sphere_relation(q...); }, question);
    }
  };

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "mixed",
                                     .pages = "23",
                                     .question = "Where does the closed segment enter and leave the ball, or disc?",
                                     .kind = Kind::measure,
                                     .fields = {"segment", "sphere"},
                                     .ulps = 27,
                                     .margin_degree = 2};

  static Question of(const Course& course, const Sphere3d& ball, bool in_plane) {
    const auto& [p, v] = course;
    const Point3d q = p + v;
    if (in_plane) return InPlane{{{p.x, p.y}, {q.x, q.y}}, {{ball.center.x, ball.center.y}, ball.radius}};
    return InSpace{{p, q}, ball};
  }
  static bool has_interior(const Circle2d& disc) { return disc.radius > 0; }
  static bool has_interior(const Sphere3d& ball) { return ball.radius > 0; }

  static void standard(const auto& add) {
    add("half the linear coefficient", [](const auto&... q) {
      return ::touchstone::reference::standard::segment_sphere<::touchstone::reference::standard::ByHalfCoefficient>(
          q...);
    });
    add("unit direction", [](const auto&... q) {
      return ::touchstone::reference::standard::segment_sphere<::touchstone::reference::standard::ByUnitDirection>(
          q...);
    });
  }

  static void hard_cases(HardCases<Question>& add) { line_ball_cases<segment_sphere>(add); }

  static void repair(Question& question) {
    std::visit([](auto& q) { std::get<1>(q).radius = std::fabs(std::get<1>(q).radius); }, question);
  }

  /// Tangent to a disc; moves the end.
  static Question map_centre() { return InPlane{{{1, 5}, {31, 5}}, {{16, 16}, 11}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {2, 3}; }

  static Hooks<segment_sphere> hooks() {
    return {.as_open_sets = none_if_grazing<segment_sphere>,
            .repair = repair,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::similarities, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
