// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>
#include <vector>

#include "catalogue/draw/drawing.h"
#include "report/uses.h"

/// Converts the coordinates of a scene in space to integer steps from the middle of its box, exactly.
namespace touchstone::report {

/// Steps from the middle of the scene's box to the end of its longest side.
constexpr int steps_of_box = 100000;

using SpacePoint = std::array<int, 3>;
using ExactPlace = std::array<mpq_class, 3>;

/// True if a figure has its numbers, all finite, and a plane a normal: a formula's answer may lack either.
bool drawable(const SpaceFigure& figure);

/// "question", "truth" or "answer".
const char* whose(const SpaceFigure& figure);

/// The points of a drawable figure that are given by coordinates; a plane has none.
std::vector<ExactPlace> places_of(const SpaceFigure& figure);

mpq_class radius_of(const SpaceFigure& sphere);

struct SpaceScale {
  ExactPlace low, high, middle;             ///< the scene's box
  std::array<mpq_class, 3> steps_per_unit;  ///< along x, y, z
  ExactPlace middle_but_planes;  ///< of the box of everything except planes; the origin if there is nothing else

  /// Each axis has its own scale if the extents are far apart, so that a thin scene is still visible; not if a figure
  /// is a sphere, which would be distorted, or a plane, whose normal would not be perpendicular.
  static SpaceScale of(const std::vector<SpaceFigure>& drawable_figures);

  /// To the nearest step.
  SpacePoint at(const ExactPlace& place) const;
  int radius_in_steps(const SpaceFigure& sphere) const;
  /// A displacement; nullopt if it is not finite or leads far out of the scene.
  std::optional<SpacePoint> steps(const std::array<double, 3>& displacement) const;
  /// The point at which a plane is drawn: the one nearest to everything else.
  ExactPlace foot(const SpaceFigure& plane) const;
};

}  // namespace touchstone::report
