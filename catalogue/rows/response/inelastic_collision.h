// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/bodies/impact_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/response/inelastic_collision.h"
#include "oracle/response/inelastic_collision.h"
#include "reference/response/inelastic_collision.h"
#include "robust/response/inelastic_collision.h"

namespace touchstone::catalogue::rows {

struct inelastic_collision : signatures::inelastic_collision {
  TOUCHSTONE_STAGED_MODULES(inelastic_collision)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "response",
                                     .pages = "70",
                                     .question = "Which velocity have two bodies after they met and stuck together?",
                                     .kind = Kind::measure,
                                     .fields = {"masses", "velocities"},
                                     .answer = "velocity",
                                     .ulps = 5,
                                     .margin_degree = 0,
                                     .longest_vector = 3000};

  static void hard_cases(HardCases<Question>& add) {
    add("on_lattice", asked<lattice_impact>);
    add("opposite_momenta", asked<opposite_momenta>);
    add("in_company", asked<in_company>);
    add("fly_and_wall", asked<fly_and_wall>);
    add("products_at_the_end", asked<impact_at_the_end>);
    add("at_end_of_range", asked<impact_at_end_of_range>);
    add("beside_a_tie", asked<mean_beside_a_tie>);
    add("without_a_mass", asked<without_a_mass>);
  }

  static void repair(Question& question) {
    auto& [m1, m2] = std::get<0>(question);
    make_positive(m1), make_positive(m2);
  }

  /// Both stop: moves the second velocity's y and z.
  static Question map_centre() { return {{2, 3}, {{3, -6, 9}, {-2, 4, -6}}}; }

  /// Two balls that touch in the direction in which they approach, with their velocities before and the common one
  /// after.
  static void draw(Drawing& drawing, const Question& question, const Vector3d& truth) {
    const auto& [masses, velocities] = question;
    const TouchingBalls balls = TouchingBalls::of(velocities, velocities.first - velocities.second);
    balls.draw_before(drawing, velocities), balls.draw_after(drawing, {truth, truth});
    draw_masses(drawing, masses);
  }

  static Hooks<inelastic_collision> hooks() {
    return {
        .repair = repair, .map_centre = map_centre, .draw = draw, .laws = {.maps = Laws::Maps::affine, .scales = true}};
  }

 private:
  /// The sum is 0 or small, but for a number in one component.
  static Impact opposite_momenta(DrawStream& c) {
    const Massesd m = lattice_masses(c);
    const Vector3d v = lattice_velocity(c, 20);
    return {m, {m.second * v, -m.first * v + Vector3d{0, small_integer(c), 0}}, {0, 1, 0}};
  }
  /// Masses h and h + 1: 2 q + 2 (h + 1) / (2 h + 1) is 2 q + 1, an odd number of 54 digits, and 1 / (2 h + 1) more or,
  /// exchanged, less.
  static Impact mean_beside_a_tie(DrawStream& c) {
    const double h = static_cast<double>((std::uint64_t{1} << 50) + c.below(std::uint64_t{1} << 51)),
                 q = 0x1p53 + 2 * one_to(c, std::uint64_t{1} << 51);
    const Velocitiesd v{{q, -q, 1}, {q + 2, -q - 2, 0}};
    return {c.coin() ? Massesd{h + 1, h} : Massesd{h, h + 1}, v, {1, 0, 0}};
  }

  template <auto draw>
  static Question asked(DrawStream& c) {
    const Impact i = draw(c);
    return {i.masses, i.velocities};
  }
};

}  // namespace touchstone::catalogue::rows
