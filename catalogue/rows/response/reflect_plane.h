// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/bodies/bounce_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/response/reflect_plane.h"
#include "oracle/response/reflect_plane.h"
#include "reference/response/reflect_plane.h"
#include "robust/response/reflect_plane.h"

namespace touchstone::catalogue::rows {

struct reflect_plane : signatures::reflect_plane {
  TOUCHSTONE_STAGED_MODULES(reflect_plane)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "response",
      .pages = "68",
      .question = "Which velocity has a body after it has bounced off a plane with that normal?",
      .kind = Kind::measure,
      .fields = {"velocity", "normal"},
      .answer = "velocity",
      .ulps = 14,
      .margin_degree = 0,
      .longest_vector = 3000};

  static void hard_cases(HardCases<Question>& add) {
    add("on_lattice", asked<lattice_bounce>);
    add("along_the_plane", asked<along_the_plane>);
    add("grazing", asked<grazing>);
    add("straight", asked<straight>);
    add("across_an_axis", asked<across_an_axis>);
    add("stretched_normal", asked<stretched_bounce>);
    add("products_at_the_end", asked<products_at_the_end>);
    add("at_end_of_range", asked<at_end_of_range>);
    add("beside_a_tie", asked<bounce_beside_a_tie>);
    add("without_a_normal", asked<without_a_normal>);
  }

  /// Along the plane: moves the normal's y and z.
  static Question map_centre() { return {{3, 1, 0}, {1, -3, 0}}; }

  static void draw(Drawing& drawing, const Question& question, const Vector3d& truth) {
    draw_bounce(drawing, std::get<0>(question), std::get<1>(question), truth);
  }

  static Hooks<reflect_plane> hooks() {
    return {.map_centre = map_centre, .draw = draw, .laws = {.maps = Laws::Maps::similarities, .scales = true}};
  }

 private:
  template <auto draw>
  static Question asked(DrawStream& c) {
    const Bounce b = draw(c);
    return {b.velocity, b.normal};
  }
};

}  // namespace touchstone::catalogue::rows
