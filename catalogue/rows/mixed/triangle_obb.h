// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/triangles/obb_triangle_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/triangle_obb.h"
#include "oracle/mixed/triangle_obb.h"
#include "reference/mixed/triangle_obb.h"
#include "robust/mixed/triangle_obb.h"

namespace touchstone::catalogue::rows {

struct triangle_obb : signatures::triangle_obb {
  TOUCHSTONE_STAGED_MODULES(triangle_obb)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "mixed",
                                     .pages = "21, 27, 45-47, 54",
                                     .question = "Do a triangle and an oriented box overlap, only touch, or neither?",
                                     .kind = Kind::decision,
                                     .fields = {"triangle", "obb"},
                                     .answer = "contact",
                                     .margin_degree = 2,
                                     .cost = 10};

  static void hard_cases(HardCases<Question>& add) {
    add_triangles_and_boxes([&add](const char* family, auto draw) { add(family, draw); });
  }

  /// A side whose middle (7, 3, 0) is on an edge of a box that is turned by the triple 3, 4, 5; moves an end of it.
  static Question map_centre() {
    return {{{7, 11, 4}, {7, -5, -4}, {21, 4, 1}}, {{0, 2, 0}, {{3, 4, 0}, {4, -3, 0}, {0, 0, 2}}}};
  }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<triangle_obb> hooks() {
    return {.as_open_sets = disjoint_if_touching<Question>,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::affine, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
