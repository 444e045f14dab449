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
        .cost = 60,
        .time = grows(Growth::cubic),
        .longest_vector = 6000};
    return metadata;
  }

  static std::vector<HardCase<Question>> hard_cases() {
    return {hard<lattice_impacts>("lattice"),
            hard<balls_head_on>("head_on"),
            hard<grazing_balls>("grazing"),
            hard<row_of_impacts>("row"),
            hard<stacked_impacts>("stack"),
            hard<impact_in_a_corner>("corner"),
            hard<overlapping_impacts>("overlapping"),
            hard<immovable_impacts>("immovable"),
            hard<impacts_of_particles>("particles"),
            hard<caught_bullets>("bullet"),
            hard<slanted_impacts>("slanted_wall"),
            hard<broken_racks>("broken_rack"),
            hard<to_and_fro>("to_and_fro"),
            hard<equal_moments>("equal_moments"),
            hard<unequal_impacts>("unequal_masses"),
            hard<full_digit_impacts>("full_digits"),
            hard<impacts_at_the_ends>("at_the_ends"),
            hard<refused_impacts>("refused"),
            hard<many_impacts>("many_balls", /*unscaled=*/true),
            hard<impacts_of_many_walls>("many_walls", /*unscaled=*/true)};
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

  /// Two balls of radius 1 and 2 on the x axis and one beside it, of inverse mass 0, 1 or 2 and of speed -3, 0 or 3,
  /// before a wall; e is 0, 1/2 or 1. Where a run makes every number less by 1 others are valid: so the timestep is 2.
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
  static HardCase<Question> hard(const char* name, bool unscaled = false) {
    return {name,
            [](DrawStream& c) -> Question {
              Impacting s = draw(c);
              return {std::move(s.bodies), std::move(s.walls), s.restitution, s.timestep};
            },
            unscaled};
  }
};

}  // namespace touchstone::catalogue::rows
