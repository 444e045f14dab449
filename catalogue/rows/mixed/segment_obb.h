// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/passages/line_obb_cases.h"
#include "catalogue/operation/open_passages.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/segment_obb.h"
#include "oracle/mixed/segment_obb.h"
#include "reference/mixed/segment_obb.h"
#include "robust/mixed/segment_obb.h"

namespace touchstone::catalogue::rows {

struct segment_obb : signatures::segment_obb {
  TOUCHSTONE_STAGED_MODULES(segment_obb)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "mixed",
                                     .pages = "27, 45-47",
                                     .question = "Where does the closed segment enter and leave the oriented box?",
                                     .kind = Kind::measure,
                                     .fields = {"segment", "obb"},
                                     .ulps = 23,
                                     .cost = 4,
                                     .longest_vector = 2300};

  static Question of(const Course& course, const Obb3d& box) {
    return {{course.from, course.from + course.displacement}, box};
  }
  static bool has_interior(const Obb3d&) { return true; }

  static void hard_cases(HardCases<Question>& add) { line_obb_cases<segment_obb>(add); }

  /// By the corner (11, 19, 0.5) of a box that is turned by the triple 3, 4, 5; moves the end.
  static Question map_centre() {
    return {{{0, 8, 0.5}, {22, 30, 0.5}}, {{12, 12, 0.5}, {{3, 4, 0}, {-4, 3, 0}, {0, 0, 0.5}}}};
  }
  static std::pair<std::size_t, std::size_t> map_axes() { return {3, 4}; }

  static Hooks<segment_obb> hooks() {
    return {.as_open_sets = none_if_grazing<segment_obb>,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::affine, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
