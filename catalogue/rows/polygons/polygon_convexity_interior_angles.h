// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/rows/polygons/polygon_convexity.h"
#include "reference/polygons/polygon_convexity_interior_angles.h"

namespace touchstone::catalogue::rows {

/// The deck's other method for the same question.
struct polygon_convexity_interior_angles : polygon_convexity {
  static auto reference(const auto&... q) { return ::touchstone::reference::polygon_convexity_interior_angles(q...); }

  static const Metadata& metadata() {
    static const Metadata metadata = [] {
      Metadata other = polygon_convexity::metadata();
      other.name = "polygon_convexity_interior_angles";
      other.pages = "6";
      other.question = "Is the polygon convex, by its interior angles?";
      other.implementation_of = "polygon_convexity";
      other.cost = 3;  // its exact arithmetic has thousands of digits
      other.time = {.robust = Growth::linearithmic,
                    .oracle = Growth::linearithmic,
                    .ask = Growth::linearithmic,
                    .reference = Growth::quadratic};
      return other;
    }();
    return metadata;
  }
};

}  // namespace touchstone::catalogue::rows
