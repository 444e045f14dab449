// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/passages/line_obb_cases.h"
#include "catalogue/operation/open_passages.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/ray_obb.h"
#include "oracle/mixed/ray_obb.h"
#include "reference/mixed/ray_obb.h"
#include "robust/mixed/ray_obb.h"

namespace touchstone::catalogue::rows {

struct ray_obb : signatures::ray_obb {
  TOUCHSTONE_STAGED_MODULES(ray_obb)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "mixed",
                                     .pages = "9, 27, 45-47",
                                     .question = "Where does the ray enter and leave the oriented box?",
                                     .kind = Kind::measure,
                                     .fields = {"ray", "obb"},
                                     .ulps = 20,
                                     .cost = 4,
                                     .longest_vector = 2300};

  static Question of(const Course& course, const Obb3d& box) { return {{course.from, course.displacement}, box}; }
  static bool has_interior(const Obb3d&) { return true; }

  static void hard_cases(HardCases<Question>& add) { line_obb_cases<ray_obb>(add); }

  /// By the corner (11, 19, 0.5) of a box that is turned by the triple 3, 4, 5; moves the direction.
  static Question map_centre() {
    return {{{0, 8, 0.5}, {11, 11, 0}}, {{12, 12, 0.5}, {{3, 4, 0}, {-4, 3, 0}, {0, 0, 0.5}}}};
  }
  static std::pair<std::size_t, std::size_t> map_axes() { return {3, 4}; }

  static Hooks<ray_obb> hooks() {
    return {.as_open_sets = none_if_grazing<ray_obb>,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::affine, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
