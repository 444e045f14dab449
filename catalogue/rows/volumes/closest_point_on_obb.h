// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/points_and_boxes.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/volumes/closest_point_on_obb.h"
#include "oracle/volumes/closest_point_on_obb.h"
#include "reference/volumes/closest_point_on_obb.h"
#include "robust/volumes/closest_point_on_obb.h"

namespace touchstone::catalogue::rows {

struct closest_point_on_obb : signatures::closest_point_on_obb {
  TOUCHSTONE_STAGED_MODULES(closest_point_on_obb)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "volumes",
      .pages = "27, 48-50",
      .question = "Which point of an oriented box is nearest to the point, and how far is it?",
      .kind = Kind::measure,
      .fields = {"point", "obb"},
      .ulps = 63,
      .margin_degree = 0,
      .cost = 12,
      .longest_vector = 2300};

  static void hard_cases(HardCases<Question>& add) {
    add_points_and_boxes([&add](const char* family, auto draw) { add(family, draw); });
  }

  /// Moves a point at the corner (15, 17, 0) of a box that is turned by the triple 3, 4, 5.
  static Question map_centre() { return {{15, 17, 0}, {{8, 16, 0}, {{4, -3, 0}, {3, 4, 0}, {0, 0, 1}}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<closest_point_on_obb> hooks() {
    return {.map_centre = map_centre, .map_axes = map_axes, .laws = {.maps = Laws::Maps::axes}};
  }
};

}  // namespace touchstone::catalogue::rows
