// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/passages/plane_sweeps.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/sweeps/swept_capsule_plane.h"
#include "oracle/sweeps/swept_capsule_plane.h"
#include "reference/sweeps/swept_capsule_plane.h"
#include "robust/sweeps/swept_capsule_plane.h"

namespace touchstone::catalogue::rows {

struct swept_capsule_plane : signatures::swept_capsule_plane, OverPlane<Capsule3d, Vector3d> {
  TOUCHSTONE_STAGED_MODULES(swept_capsule_plane)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "sweeps",
      .pages = "22-23, 51",
      .question = "When in a step does a moving capsule first have a common point with a plane?",
      .kind = Kind::measure,
      .fields = {"capsule", "velocity", "plane"},
      .ulps = 20,
      .margin_degree = 2};

  static void hard_cases(HardCases<Question>& add) {
    add_balls_to_planes([&add]<class Draw>(const char* family, Draw) {
      add(family, [](DrawStream& c) -> Question {
        const auto [ball, velocity, plane] = Draw{}(c);
        return {with_end(c, ball, plane.normal), velocity, plane};
      });
    });
    add("nearly_level", [](DrawStream& c) -> Question {
      // The ends are as high, but for rounding, or on both sides of the plane by as little.
      const Vector3d n{ordinary(c), ordinary(c), 1}, v{ordinary(c), ordinary(c), ordinary(c)};
      const Point3d p{ordinary(c), ordinary(c), ordinary(c)};
      const double x = ordinary(c), y = ordinary(c), r = c.coin() ? 0 : std::ldexp(std::fabs(ordinary(c)), -3);
      const double d = c.coin() ? ordinary(c) : -dot(n, Vector3d{p.x, p.y, p.z});
      return {{{p, p + Vector3d{x, y, -(n.x * x + n.y * y)}}, r}, v, {n, d}};
    });
  }

  /// An end just gets to the plane x + 2y + 2z = 0: moves y and z of the other.
  static Question map_centre() { return {{{{3, 6, 6}, {4, 7, 5}}, 6}, {-1, -2, -2}, {{1, 2, 2}, 0}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {4, 5}; }

  /// The step: the capsule at its start, at the first contact and at its end.
  static void draw(Drawing& drawing, const Question& question, const FirstContact<double>& truth) {
    draw_step(drawing, "capsule", "plane", question, truth.t);
  }

  static Hooks<swept_capsule_plane> hooks() {
    return {.as_open_sets = never_if_grazing<swept_capsule_plane>,
            .repair = repair_radii<Question>,
            .scale = scale,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .draw = draw,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
