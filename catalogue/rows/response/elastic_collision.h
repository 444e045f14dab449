// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/bodies/impact_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/response/elastic_collision.h"
#include "oracle/response/elastic_collision.h"
#include "reference/response/elastic_collision.h"
#include "robust/response/elastic_collision.h"

namespace touchstone::catalogue::rows {

struct elastic_collision : signatures::elastic_collision {
  TOUCHSTONE_STAGED_MODULES(elastic_collision)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "response",
      .pages = "69",
      .question = "Which velocities have two bodies after they bounced off each other without loss?",
      .kind = Kind::measure,
      .fields = {"masses", "velocities", "normal"},
      .answer = "velocities",
      .ulps = 19,
      .margin_degree = 0,
      .longest_vector = 4500};

  static void hard_cases(HardCases<Question>& add) {
    add("on_lattice", asked<lattice_impact>);
    add("head_on", asked<head_on>);
    add("grazing", asked<grazing_impact>);
    add("in_company", asked<in_company>);
    add("fly_and_wall", asked<fly_and_wall>);
    add("stretched_normal", asked<stretched_impact>);
    add("products_at_the_end", asked<impact_at_the_end>);
    add("at_end_of_range", asked<impact_at_end_of_range>);
    add("beside_a_tie", asked<impact_beside_a_tie>);
    add("without_a_mass", asked<without_a_mass>);
    add("without_a_normal", asked<impact_without_a_normal>);
  }

  static void repair(Question& question) {
    auto& [m1, m2] = std::get<0>(question);
    make_positive(m1), make_positive(m2);
  }

  /// The first body stops: moves the normal's y and z.
  static Question map_centre() { return {{3, 3}, {{3, 1, 0}, {0, 0, 0}}, {3, 1, 0}}; }

  /// Two balls at their contact, with their velocities before and after.
  static void draw(Drawing& drawing, const Question& question, const Velocitiesd& truth) {
    const auto& [masses, velocities, normal] = question;
    const TouchingBalls balls = TouchingBalls::of(velocities, normal);
    balls.draw_before(drawing, velocities, normal), balls.draw_after(drawing, truth);
    draw_masses(drawing, masses);
  }

  static Hooks<elastic_collision> hooks() {
    return {.repair = repair,
            .map_centre = map_centre,
            .draw = draw,
            .laws = {.maps = Laws::Maps::similarities, .scales = true}};
  }

 private:
  template <auto draw>
  static Question asked(DrawStream& c) {
    const Impact i = draw(c);
    return {i.masses, i.velocities, i.normal};
  }
};

}  // namespace touchstone::catalogue::rows
