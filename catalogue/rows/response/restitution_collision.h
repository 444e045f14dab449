// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/bodies/impact_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/response/restitution_collision.h"
#include "oracle/response/restitution_collision.h"
#include "reference/response/restitution_collision.h"
#include "robust/response/restitution_collision.h"

namespace touchstone::catalogue::rows {

struct restitution_collision : signatures::restitution_collision {
  TOUCHSTONE_STAGED_MODULES(restitution_collision)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "response",
      .pages = "70",
      .question = "Which velocities have two bodies after a bounce with a coefficient of restitution?",
      .kind = Kind::measure,
      .fields = {"masses", "velocities", "normal", "e"},
      .answer = "velocities",
      .ulps = 21,
      .margin_degree = 0,
      .cost = 2,
      .longest_vector = 4500};

  static void hard_cases(HardCases<Question>& add) {
    add("on_lattice", asked<lattice_impact, usual>);
    add("head_on", asked<head_on, usual>);
    add("grazing", asked<grazing_impact, usual>);
    add("in_company", asked<in_company, usual>);
    add("fly_and_wall", asked<fly_and_wall, at_an_end>);
    add("stretched_normal", asked<stretched_impact, usual>);
    add("products_at_the_end", asked<impact_at_the_end, usual>);
    add("at_end_of_range", asked<impact_at_end_of_range, at_an_end>);
    add("beside_a_tie", asked<impact_beside_a_tie, one>);
    add("without_a_mass", asked<without_a_mass, usual>);
    add("without_a_normal", asked<impact_without_a_normal, usual>);
    add("e_at_a_bound", asked<lattice_impact, restitution_at_a_bound>);
  }

  /// e has no unit: it keeps its value.
  static void scale(Question& question, int exponent) {
    auto& [m, velocities, n, e] = question;
    m = {std::ldexp(m.first, exponent), std::ldexp(m.second, exponent)};
    for (Vector3d* v : {&velocities.first, &velocities.second, &n})
      *v = {std::ldexp(v->x, exponent), std::ldexp(v->y, exponent), std::ldexp(v->z, exponent)};
  }

  static void repair(Question& question) {
    auto& [m, velocities, n, e] = question;
    make_positive(m.first), make_positive(m.second);
    e = std::fabs(e);
    if (e > 1) e = 1 / e;
  }

  /// The first body stops: moves the normal's z and e.
  static Question map_centre() { return {{1, 2}, {{3, 1, 0}, {0, 0, 0}}, {3, 1, 0}, 0.5}; }

  /// Two balls at their contact, with their velocities before and after.
  static void draw(Drawing& drawing, const Question& question, const Velocitiesd& truth) {
    const auto& [masses, velocities, normal, e] = question;
    const TouchingBalls balls = TouchingBalls::of(velocities, normal);
    balls.draw_before(drawing, velocities, normal), balls.draw_after(drawing, truth);
    draw_masses(drawing, masses);
    drawing.notes.push_back("e = " + decimal(e));
  }

  static Hooks<restitution_collision> hooks() {
    return {.repair = repair,
            .scale = scale,
            .map_centre = map_centre,
            .draw = draw,
            .laws = {.maps = Laws::Maps::similarities, .scales = true}};
  }

 private:
  static double usual(DrawStream& c) { return c.coin() ? up_to(c, 16) / 16 : 0.1 * up_to(c, 10); }
  static double one(DrawStream&) { return 1; }
  static double at_an_end(DrawStream& c) {
    constexpr double ends[]{1, 0, -0.0, 0x1p-1074, 0x1p-60, 0x1.fffffffffffffp-1, 0x1p-900};
    return ends[c.below(7)];
  }

  template <auto draw, auto draw_e>
  static Question asked(DrawStream& c) {
    const Impact i = draw(c);
    return {i.masses, i.velocities, i.normal, draw_e(c)};
  }
};

}  // namespace touchstone::catalogue::rows
