// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/bodies/impact_step_draws.h"
#include "catalogue/numbers/kept_digits.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/response/impact_step.h"
#include "oracle/response/impact_step.h"
#include "reference/response/impact_step.h"
#include "robust/response/impact_step.h"

namespace touchstone::catalogue::rows {

struct impact_step : signatures::impact_step {
  TOUCHSTONE_MODULES(impact_step)
  using decision = NoDecision;

  static const Metadata& metadata() {
    static const Metadata metadata{
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
    return metadata;
  }

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
    const auto scale = [exponent](auto& v) {
      v = {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
    };
    for (auto& [w, v, sphere] : bodies) {
      scale(v), scale(sphere.center);
      sphere.radius = std::ldexp(sphere.radius, exponent);
    }
    for (Plane3d& wall : walls) wall.offset = std::ldexp(wall.offset, exponent);
  }

  /// At most three bodies and two walls.
  static void repair(Question& question) {
    auto& [bodies, walls, restitution, timestep] = question;
    if (bodies.size() > 3) bodies.resize(3);
    if (walls.size() > 2) walls.resize(2);
    for (auto& [w, v, sphere] : bodies) {
      w = std::fabs(w), sphere.radius = std::fabs(sphere.radius);
      if (validation::zero(w)) v = {0, 0, 0};
    }
    for (Plane3d& wall : walls) wall.normal = not_zero(wall.normal);
    make_positive(timestep);
    restitution = std::fabs(restitution);
    if (restitution > 1) restitution = 1 / restitution;
  }

  /// A ball that just passes another, or hits it: moves the second one's height and radius.
  static Question map_centre() { return {{{1, {4, 0, 0}, {{-3, 0, 0}, 1}}, {1, {0, 0, 0}, {{0, 2, 0}, 1}}}, {}, 1, 1}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {13, 15}; }

  /// Balls where they start with their velocities, and walls; and where they come to, with their velocities there.
  static void draw(Drawing& drawing, const Question& question, const ImpactStepd& truth) {
    const auto& [bodies, walls, restitution, timestep] = question;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const auto& [w, v, sphere] = bodies[i];
      const std::string name = std::to_string(i);
      catalogue::draw(drawing, name, sphere, false);
      if (!is_zero(v)) draw_arrow(drawing, "velocity of " + name, sphere.center, v, false);
      if (!truth.bodies || i >= truth.bodies->size()) continue;
      const auto& [at, after] = (*truth.bodies)[i];
      const std::vector<std::string> notes = drawing.notes;
      catalogue::draw(drawing, name + " after", Sphere3d{at, sphere.radius}, true);
      drawing.notes = notes;
      if (!is_zero(after)) draw_arrow(drawing, "velocity of " + name + " after", at, after, true);
    }
    for (std::size_t k = 0; k < walls.size(); ++k)
      catalogue::draw(drawing, "wall " + std::to_string(k), walls[k], false);
    for (const auto& [t, contacts] : truth.moments)
      for (const auto& [i, j] : contacts) {
        const bool wall = j >= bodies.size();
        const std::string other = wall ? "wall " + std::to_string(j - bodies.size()) : std::to_string(j);
        drawing.notes.push_back(std::to_string(i) + " meets " + other + " at t = " + decimal(t));
      }
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
    const auto next = [&index](std::uint64_t of) {
      const std::uint64_t digit = index % of;
      index /= of;
      return static_cast<double>(digit);
    };
    const double e = next(restitutions) / 2;
    Impacting s{{}, {{{1, 0, 0}, 0}}, e, 2};
    for (int i = 0; i < 3; ++i) {
      const double w = next(masses), speed = 3 * (next(speeds) - 1);
      const double place = 2 * next(static_cast<std::uint64_t>(size));
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
