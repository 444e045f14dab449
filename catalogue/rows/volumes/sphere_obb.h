// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/round_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/volumes/sphere_obb.h"
#include "oracle/volumes/sphere_obb.h"
#include "reference/volumes/sphere_obb.h"
#include "robust/batch/sphere_obb.h"
#include "robust/volumes/sphere_obb.h"

namespace touchstone::catalogue::rows {

struct sphere_obb : signatures::sphere_obb {
  TOUCHSTONE_STAGED_MODULES(sphere_obb)
  TOUCHSTONE_ARRAYS(sphere_obb)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "volumes",
                                     .pages = "27, 48-50",
                                     .question = "Do a ball and an oriented box overlap, only touch, or neither?",
                                     .kind = Kind::decision,
                                     .fields = {"sphere", "obb"},
                                     .answer = "contact",
                                     .margin_degree = 2,
                                     .cost = 10,
                                     .longest_vector = 2300};

  static void hard_cases(HardCases<Question>& add) {
    add_balls_and_boxes([&add](const char* family, auto draw) { add(family, draw); });
  }

  /// A ball that reaches the corner (15, 17, 0) of a box that is turned by the triple 3, 4, 5; moves its center.
  static Question map_centre() { return {{{20, 17, 0}, 5}, {{8, 16, 0}, {{4, -3, 0}, {3, 4, 0}, {0, 0, 1}}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<sphere_obb> hooks() { return hooks_of_round_pair<sphere_obb>(); }
};

}  // namespace touchstone::catalogue::rows
