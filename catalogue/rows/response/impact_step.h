// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/bodies/balls_and_walls.h"
#include "catalogue/families/bodies/impact_step_draws.h"
#include "catalogue/numbers/kept_digits.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/response/impact_step.h"
#include "oracle/response/impact_step.h"
#include "reference/response/impact_step.h"
#include "robust/response/impact_step.h"

namespace touchstone::catalogue::rows {

struct impact_step : signatures::impact_step {
  TOUCHSTONE_STAGED_MODULES(impact_step)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "response",
      .pages = "23, 51, 55-56, 64-71, 74",
      .question = "When do balls among walls collide within a step of time, and where are they at its end?",
      .kind = Kind::measure,
      .fields = {"bodies", "walls", "restitution", "timestep"},
      .ulps = 94,
      .margin_degree = 0,
      .cost = 100,
      .time = grows(Growth::cubic),
      .longest_vector = 6000};

  static void hard_cases(HardCases<Question>& add) {
    add("lattice", asked<lattice_impacts>);
    add("head_on", asked<balls_head_on>);
    add("grazing", asked<grazing_balls>);
    add("row", asked<row_of_impacts>);
    add("stack", asked<stacked_impacts>);
    add("corner", asked<impact_in_a_corner>);
    add("overlapping", asked<overlapping_impacts>);
    add("immovable", asked<immovable_impacts>);
    add("particles", asked<impacts_of_particles>);
    add("bullet", asked<caught_bullets>);
    add("slanted_wall", asked<slanted_impacts>);
    add("broken_rack", asked<broken_racks>);
    add("to_and_fro", asked<to_and_fro>);
    add("equal_moments", asked<equal_moments>);
    add("unequal_masses", asked<unequal_impacts>);
    add("full_digits", asked<full_digit_impacts>);
    add("at_the_ends", asked<impacts_at_the_ends>);
    add("refused", asked<refused_impacts>);
    add.unscaled("many_balls", asked<many_impacts>);
    add.unscaled("many_walls", asked<impacts_of_many_walls>);
  }

  /// Masses, time, normals and the restitution keep their value.
  static void scale(Question& question, int exponent) {
    auto& [bodies, walls, restitution, timestep] = question;
    scale_lengths(bodies, walls, exponent);
  }

  static void repair(Question& question) {
    auto& [bodies, walls, restitution, timestep] = question;
    repair_step(bodies, walls, 3, timestep, restitution);
  }

  /// A ball that just passes another, or hits it: moves the second one's height and radius.
  static Question map_centre() { return {{{1, {4, 0, 0}, {{-3, 0, 0}, 1}}, {1, {0, 0, 0}, {{0, 2, 0}, 1}}}, {}, 1, 1}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {13, 15}; }

  static void draw(Drawing& drawing, const Question& question, const ImpactStepd& truth) {
    const auto& [bodies, walls, restitution, timestep] = question;
    draw_step(drawing, bodies, walls, truth.bodies.value_or(std::vector<BodyState<double>>{}));
    for (const auto& [t, contacts] : truth.moments)
      for (const auto& [i, j] : contacts)
        drawing.notes.push_back(meeting(i, j, bodies.size()) + " at t = " + decimal(t));
    drawing.notes.push_back("restitution " + decimal(restitution) + ", timestep " + decimal(timestep));
  }

  /// Two balls of radius 1 and 2 on the x axis and one off it, of inverse mass 0, 1 or 2 and of speed -3, 0 or 3,
  /// before a wall; e is 0, 1/2 or 1. A run that makes every number less by 1 still needs valid ones, so the timestep
  /// is 2.
  static constexpr std::uint64_t masses = 3, speeds = 3, restitutions = 3;
  static std::uint64_t domain_count(int size) {
    const auto n = static_cast<std::uint64_t>(size), one = n * masses * speeds;
    return one * one * one * restitutions;
  }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    const double e = static_cast<double>(digit.next(restitutions)) / 2;
    Impacting s{{}, {{{1, 0, 0}, 0}}, e, 2};
    for (int i = 0; i < 3; ++i) {
      const auto w = static_cast<double>(digit.next(masses)), v = static_cast<double>(digit.next(speeds));
      const double place = 2 * digit(), speed = 3 * (v - 1);
      s.add({place, i == 2 ? 2.0 : 0.0, 0}, i == 0 ? 1 : 2, w, {speed, 0, 0});
    }
    return {std::move(s.bodies), std::move(s.walls), s.restitution, s.timestep};
  }

  static Hooks<impact_step> hooks() {
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
    Impacting s = draw(c);
    return {std::move(s.bodies), std::move(s.walls), s.restitution, s.timestep};
  }
};

}  // namespace touchstone::catalogue::rows
