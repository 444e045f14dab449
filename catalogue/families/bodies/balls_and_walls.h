// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "catalogue/draw/motions.h"
#include "catalogue/families/bodies/simultaneous_draws.h"
#include "geometry/steps.h"
#include "geometry/validation.h"

/// Balls among walls, for rows of steps: in other units, with valid numbers, and drawn.
namespace touchstone::catalogue {

/// Masses and normals keep their values.
inline void scale_lengths(std::vector<StepBodyd>& bodies, std::vector<Plane3d>& walls, int exponent) {
  for (auto& [w, v, sphere] : bodies) {
    lengthen(v, exponent), lengthen(sphere.center, exponent);
    sphere.radius = std::ldexp(sphere.radius, exponent);
  }
  for (Plane3d& wall : walls) wall.offset = std::ldexp(wall.offset, exponent);
}

/// At most so many bodies and two walls, of numbers that are valid.
inline void repair_step(std::vector<StepBodyd>& bodies, std::vector<Plane3d>& walls, std::size_t most_bodies,
                        double& timestep, double& restitution) {
  if (bodies.size() > most_bodies) bodies.resize(most_bodies);
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

/// Balls where they start with their velocities, and walls; and, as far as it is known, where they come to, with their
/// velocities there.
inline void draw_step(Drawing& drawing, const std::vector<StepBodyd>& bodies, const std::vector<Plane3d>& walls,
                      const std::vector<BodyState<double>>& at_the_end) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto& [w, v, sphere] = bodies[i];
    const std::string name = std::to_string(i);
    draw(drawing, name, sphere, false);
    if (!is_zero(v)) draw_arrow(drawing, "velocity of " + name, sphere.center, v, false);
    if (i >= at_the_end.size()) continue;
    const auto& [at, after] = at_the_end[i];
    const std::vector<std::string> notes = drawing.notes;
    draw(drawing, name + " after", Sphere3d{at, sphere.radius}, true);
    drawing.notes = notes;
    if (!is_zero(after)) draw_arrow(drawing, "velocity of " + name + " after", at, after, true);
  }
  for (std::size_t k = 0; k < walls.size(); ++k) draw(drawing, "wall " + std::to_string(k), walls[k], false);
}

/// "0 meets 1", "0 meets wall 0": walls are counted after the bodies.
inline std::string meeting(Index i, Index j, std::size_t bodies) {
  const std::string other = j >= bodies ? "wall " + std::to_string(j - bodies) : std::to_string(j);
  return std::to_string(i) + " meets " + other;
}

}  // namespace touchstone::catalogue
