// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "catalogue/draw/drawing.h"
#include "report/figures/viewport.h"

namespace touchstone::report {

/// The exact vertices that define a figure.
std::vector<ExactPoint> vertices_of(const Figure& figure);

/// A vertex that is so near to another part of the question that the figure cannot show the gap, and yet does not touch
/// it.
struct NearMiss {
  ExactPoint vertex;
  double x = 0, y = 0;  ///< the vertex in doubles
  std::string label;
  mpq_class gap;  ///< the distance, in the unit of the coordinates, to many digits
};

/// The narrowest gap in the question that is below a few pixels of the view, not zero, and at least `least`. Lines
/// without a name and arrows have none.
std::optional<NearMiss> narrowest_gap(const Drawing& drawing, const Viewport& view, const mpq_class& least);

}  // namespace touchstone::report
