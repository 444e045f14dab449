// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/passages/plane_sweeps.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/sweeps/swept_sphere_plane.h"
#include "oracle/sweeps/swept_sphere_plane.h"
#include "reference/sweeps/swept_sphere_plane.h"
#include "robust/sweeps/swept_sphere_plane.h"

namespace touchstone::catalogue::rows {

struct swept_sphere_plane : signatures::swept_sphere_plane, OverPlane<Sphere3d, Vector3d> {
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
    add_balls_to_planes([&add]<class Draw>(const char* family, Draw) {
      add(family, [](DrawStream& c) -> Question { return Draw{}(c); });
    });
  }

  /// It just gets to the plane x + 2y + 2z = 0: moves y and z of the velocity.
  static Question map_centre() { return {{{3, 6, 6}, 6}, {-1, -2, -2}, {{1, 2, 2}, 0}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {5, 6}; }

  /// The step: the ball at its start, at the first contact and at its end.
  static void draw(Drawing& drawing, const Question& question, const FirstContact<double>& truth) {
    draw_step(drawing, "sphere", "plane", question, truth.t);
  }

  static Hooks<swept_sphere_plane> hooks() {
    return {.as_open_sets = never_if_grazing<swept_sphere_plane>,
            .repair = repair_radii<Question>,
            .scale = scale,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .draw = draw,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
