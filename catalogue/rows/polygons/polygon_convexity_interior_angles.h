// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/rows/polygons/polygon_convexity.h"
#include "reference/polygons/polygon_convexity_interior_angles.h"

namespace touchstone::catalogue::rows {

/// The deck's other method for the same question.
struct polygon_convexity_interior_angles : polygon_convexity {
  static auto reference(const auto&... q) { return ::touchstone::reference::polygon_convexity_interior_angles(q...); }

  /// Its exact arithmetic has thousands of digits.
  static constexpr Metadata metadata =
      polygon_convexity::metadata.implementation({.name = "polygon_convexity_interior_angles",
                                                  .pages = "6",
                                                  .question = "Is the polygon convex, by its interior angles?",
                                                  .cost = 3,
                                                  .time = {.robust = Growth::linearithmic,
                                                           .oracle = Growth::linearithmic,
                                                           .ask = Growth::linearithmic,
                                                           .reference = Growth::quadratic}});
};

}  // namespace touchstone::catalogue::rows
