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
  TOUCHSTONE_MODULES(elastic_collision)
  using stages = ::touchstone::robust::stages::elastic_collision;
  using decision = NoDecision;

  static const Metadata& metadata() {
    static const Metadata metadata{
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
    return metadata;
  }

  static std::vector<HardCase<Question>> hard_cases() {
    return {hard<lattice_impact>("on_lattice"),
            hard<head_on>("head_on"),
            hard<grazing_impact>("grazing"),
            hard<in_company>("in_company"),
            hard<fly_and_wall>("fly_and_wall"),
            hard<stretched_impact>("stretched_normal"),
            hard<impact_at_the_end>("products_at_the_end"),
            hard<impact_at_end_of_range>("at_end_of_range"),
            hard<impact_beside_a_tie>("beside_a_tie"),
            hard<without_a_mass>("without_a_mass"),
            hard<impact_without_a_normal>("without_a_normal")};
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
  static HardCase<Question> hard(const char* name) {
    return {name, [](DrawStream& c) -> Question {
              const Impact i = draw(c);
              return {i.masses, i.velocities, i.normal};
            }};
  }
};

}  // namespace touchstone::catalogue::rows
