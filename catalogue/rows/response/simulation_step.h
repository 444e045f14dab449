// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/bodies/balls_and_walls.h"
#include "catalogue/families/bodies/step_draws.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/response/simulation_step.h"
#include "oracle/response/simulation_step.h"
#include "reference/response/simulation_step.h"
#include "robust/response/simulation_step.h"

namespace touchstone::catalogue::rows {

struct simulation_step : signatures::simulation_step {
  TOUCHSTONE_STAGED_MODULES(simulation_step)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "response",
      .pages = "23, 55-56, 64-71, 74",
      .question = "Where are balls among walls after a step of time, how do they move then, and what did they meet?",
      .kind = Kind::measure,
      .fields = {"bodies", "walls", "settings"},
      .ulps = 98,
      .margin_degree = 0,
      .cost = 11,
      .time = grows(Growth::quadratic),
      .longest_vector = 6000};

  static void hard_cases(HardCases<Question>& add) {
    add("lattice", asked<lattice_balls>);
    add("tangent", asked<tangent_balls>);
    add("row", asked<row_of_balls>);
    add("stack", asked<stacked_balls>);
    add("corner", asked<ball_in_a_corner>);
    add("overlapping", asked<overlapping_balls>);
    add("immovable", asked<immovable_balls>);
    add("particles", asked<particles>);
    add("sliding", asked<sliding_balls>);
    add("bullet", asked<bullets>);
    add("unequal_masses", asked<unequal_balls>);
    add("full_digits", asked<full_digit_balls>);
    add("rounded_tangent", asked<rounded_tangent_balls>);
    add("at_the_ends", asked<balls_at_the_ends>);
    add("beside_a_tie", asked<step_beside_a_tie>);
    add("refused", asked<refused_step>);
    add.unscaled("many_balls", asked<many_balls>);
    add.unscaled("many_walls", asked<many_walls>);
  }

  /// Masses, time, normals and the restitution keep their value.
  static void scale(Question& question, int exponent) {
    auto& [bodies, walls, settings] = question;
    scale_lengths(bodies, walls, exponent);
    lengthen(settings.gravity, exponent);
  }

  /// Few: exact values of random bits grow by thousands of digits a contact.
  static void repair(Question& question) {
    auto& [bodies, walls, settings] = question;
    repair_step(bodies, walls, 4, settings.timestep, settings.restitution);
  }

  /// Two balls of one mass that just touch at the end of the step, when one has hit the other: moves the second one's
  /// height and radius.
  static Question map_centre() {
    const StepSettingsd settings{{0, 0, 0}, StepMotion::accelerate_then_move, 1, 1, StepTurn::after_move};
    return {{{1, {1, 0, 0}, {{-3, 0, 0}, 1}}, {1, {0, 0, 0}, {{0, 0, 0}, 1}}}, {}, settings};
  }
  static std::pair<std::size_t, std::size_t> map_axes() { return {13, 15}; }

  static void draw(Drawing& drawing, const Question& question, const NextStated& truth) {
    const auto& [bodies, walls, settings] = question;
    draw_step(drawing, bodies, walls, truth.bodies);
    for (const auto& [i, j] : truth.contacts) drawing.notes.push_back(meeting(i, j, bodies.size()));
    drawing.notes.push_back("restitution " + decimal(settings.restitution) + ", timestep " +
                            decimal(settings.timestep));
  }

  /// Three balls of radius 2 on the x axis, of inverse mass 0, 1 or 2 and of speed -1, 0 or 1, that are 0, 2, 4 ...
  /// from a wall at the end; e is 0, 1/2 or 1. Where a run makes every number less by 1, many are refused, and
  /// others are valid: so the timestep is 2.
  static constexpr std::uint64_t masses = 3, speeds = 3, restitutions = 3, turns = 2;
  static std::uint64_t domain_count(int size) {
    const auto n = static_cast<std::uint64_t>(size), one = n * masses * speeds;
    return one * one * one * restitutions * turns;
  }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    const double e = static_cast<double>(digit.next(restitutions)) / 2;
    const StepTurn turn = digit.next(turns) == 0 ? StepTurn::before_move : StepTurn::after_move;
    Stepping s{{}, {{{1, 0, 0}, 0}}, {{0, 0, 0}, StepMotion::parabola, e, 2, turn}};
    for (int i = 0; i < 3; ++i) {
      const auto w = static_cast<double>(digit.next(masses)), v = static_cast<double>(digit.next(speeds));
      s.add({2 * digit(), 0, 0}, 2, w, {v - 1, 0, 0});
    }
    return {std::move(s.bodies), std::move(s.walls), s.settings};
  }

  static Hooks<simulation_step> hooks() {
    return {.repair = repair,
            .scale = scale,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .draw = draw,
            .domain_count = domain_count,
            .domain_at = domain_at,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }

 private:
  template <auto draw>
  static Question asked(DrawStream& c) {
    Stepping s = draw(c);
    return {std::move(s.bodies), std::move(s.walls), s.settings};
  }
};

}  // namespace touchstone::catalogue::rows
