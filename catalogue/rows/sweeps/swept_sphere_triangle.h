// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/ties.h"
#include "catalogue/families/triangles/round_triangle_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/sweeps/swept_sphere_triangle.h"
#include "oracle/sweeps/swept_sphere_triangle.h"
#include "reference/sweeps/swept_sphere_triangle.h"
#include "robust/sweeps/swept_sphere_triangle.h"

namespace touchstone::catalogue::rows {

struct swept_sphere_triangle : signatures::swept_sphere_triangle {
  TOUCHSTONE_STAGED_MODULES(swept_sphere_triangle)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "sweeps",
      .pages = "23, 54",
      .question = "When in a step does a moving ball first have a common point with a triangle in space?",
      .kind = Kind::measure,
      .fields = {"sphere", "velocity", "triangle"},
      .ulps = 53,
      .margin_degree = 2,
      .cost = 4};

  static void hard_cases(HardCases<Question>& add) {
    add("slides_over", [](DrawStream& c) -> Question {
      // Along the plane, as far from it as the radius, over an edge, a corner or past both.
      const IntegerAcross across = IntegerAcross::of(c);
      const LatticePlane plane{lattice_point_in_space(c, 16), across.u, across.v};
      const Triangle3d t = plane.triangle(c);
      const Point3d from = plane.point(c) + across.displacement;
      const double i = small_integer(c, 4), j = small_integer(c, 4);
      return {{from, across.length}, i * across.u + j * across.v, t};
    });
    add("through_the_middle", [](DrawStream& c) -> Question {
      // All edges are farther away than the radius.
      const LatticePlane plane = LatticePlane::of(c, 4);
      const double back = one_to(c, 9), far = up_to(c, 18);
      const Vector3d n = cross(plane.u, plane.v);
      return {{along(plane.origin, -back, n), up_to(c, 1)},
              far * n,
              {plane.at(16, 0), plane.at(0, 16), plane.at(-16, -16)}};
    });
    add("beside_a_tie", [](DrawStream& c) -> Question {
      const auto [low, high, fall] = way_beside_tie(c);
      return {{{0, high, 0}, 0}, {0, -fall * 0x1p54, 0}, {{-4, -low, -4}, {4, -low, -4}, {0, -low, 8}}};
    });
    // Before, after or at the place of a ball next to a triangle.
    add_balls_and_triangles([&add]<class Draw>(const char* family, const Draw&) {
      add(family, [](DrawStream& c) -> Question {
        const auto [ball, triangle] = Draw()(c);
        const Vector3d way = lattice_normal(c, 4);
        const double before = up_to(c, 2), steps = up_to(c, 3);
        return {{along(ball.center, -before, way), ball.radius}, steps * way, triangle};
      });
    });
  }

  /// It grazes the corner (4, 4, 0) by the triple 3, 4, 5; moves the center.
  static Question map_centre() { return {{{3, 11, 0}, 5}, {8, -6, 0}, {{4, 4, 0}, {-4, -4, 1}, {-4, 4, -1}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  /// The step: the ball at its start, at the first contact and at its end.
  static void draw(Drawing& drawing, const Question& question, const FirstContact<double>& truth) {
    draw_step(drawing, "sphere", "triangle", question, truth.t);
  }

  static Hooks<swept_sphere_triangle> hooks() {
    return {.as_open_sets = never_if_grazing<swept_sphere_triangle>,
            .repair = repair_radii<Question>,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .draw = draw,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
