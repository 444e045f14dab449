// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/bodies/step_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/response/simulation_step.h"
#include "oracle/response/simulation_step.h"
#include "reference/response/simulation_step.h"
#include "robust/response/simulation_step.h"

namespace touchstone::catalogue::rows {

struct simulation_step : signatures::simulation_step {
  TOUCHSTONE_MODULES(simulation_step)
  using decision = NoDecision;

  static const Metadata& metadata() {
    static const Metadata metadata{
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
    return metadata;
  }

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
    const auto scale = [exponent](auto& v) {
      v = {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
    };
    for (auto& [w, v, sphere] : bodies) {
      scale(v), scale(sphere.center);
      sphere.radius = std::ldexp(sphere.radius, exponent);
    }
    for (Plane3d& wall : walls) wall.offset = std::ldexp(wall.offset, exponent);
    scale(settings.gravity);
  }

  /// At most four bodies and two walls: exact values of random bits grow by thousands of digits a contact.
  static void repair(Question& question) {
    auto& [bodies, walls, settings] = question;
    if (bodies.size() > 4) bodies.resize(4);
    if (walls.size() > 2) walls.resize(2);
    for (auto& [w, v, sphere] : bodies) {
      w = std::fabs(w), sphere.radius = std::fabs(sphere.radius);
      if (validation::zero(w)) v = {0, 0, 0};
    }
    for (Plane3d& wall : walls) wall.normal = not_zero(wall.normal);
    make_positive(settings.timestep);
    settings.restitution = std::fabs(settings.restitution);
    if (settings.restitution > 1) settings.restitution = 1 / settings.restitution;
  }

  /// Two balls of one mass that just touch at the end of the step, when one has hit the other: moves the second one's
  /// height and radius.
  static Question map_centre() {
    const StepSettingsd settings{{0, 0, 0}, StepMotion::accelerate_then_move, 1, 1, StepTurn::after_move};
    return {{{1, {1, 0, 0}, {{-3, 0, 0}, 1}}, {1, {0, 0, 0}, {{0, 0, 0}, 1}}}, {}, settings};
  }
  static std::pair<std::size_t, std::size_t> map_axes() { return {13, 15}; }

  /// Balls where they start with their velocities, and walls; and where they come to, with their velocities there.
  static void draw(Drawing& drawing, const Question& question, const NextStated& truth) {
    const auto& [bodies, walls, settings] = question;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const auto& [w, v, sphere] = bodies[i];
      const std::string name = std::to_string(i);
      catalogue::draw(drawing, name, sphere, false);
      if (!is_zero(v)) draw_arrow(drawing, "velocity of " + name, sphere.center, v, false);
      if (i >= truth.bodies.size()) continue;
      const auto& [at, after] = truth.bodies[i];
      draw_sphere(drawing, name + " after", {at, sphere.radius});
      if (!is_zero(after)) draw_arrow(drawing, "velocity of " + name + " after", at, after, true);
    }
    for (std::size_t k = 0; k < walls.size(); ++k)
      catalogue::draw(drawing, "wall " + std::to_string(k), walls[k], false);
    for (const auto& [i, j] : truth.contacts) {
      const bool wall = j >= bodies.size();
      const std::string other = wall ? "wall " + std::to_string(j - bodies.size()) : std::to_string(j);
      drawing.notes.push_back(std::to_string(i) + " meets " + other);
    }
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
    const auto next = [&index](std::uint64_t of) {
      const std::uint64_t digit = index % of;
      index /= of;
      return static_cast<double>(digit);
    };
    const double e = next(restitutions) / 2;
    const StepTurn turn = next(turns) == 0 ? StepTurn::before_move : StepTurn::after_move;
    Stepping s{{}, {{{1, 0, 0}, 0}}, {{0, 0, 0}, StepMotion::parabola, e, 2, turn}};
    for (int i = 0; i < 3; ++i) {
      const double w = next(masses), speed = next(speeds) - 1;
      const double place = 2 * next(static_cast<std::uint64_t>(size));
      s.add({place, 0, 0}, 2, w, {speed, 0, 0});
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
  static void draw_sphere(Drawing& drawing, const std::string& label, const Sphere3d& s) {
    const std::vector<std::string> notes = drawing.notes;
    catalogue::draw(drawing, label, s, true);
    drawing.notes = notes;
  }

  template <auto draw>
  static Question asked(DrawStream& c) {
    Stepping s = draw(c);
    return {std::move(s.bodies), std::move(s.walls), s.settings};
  }
};

}  // namespace touchstone::catalogue::rows
