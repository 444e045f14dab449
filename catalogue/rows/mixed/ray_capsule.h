// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/passages/line_capsule_cases.h"
#include "catalogue/operation/open_passages.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/ray_capsule.h"
#include "oracle/mixed/ray_capsule.h"
#include "reference/mixed/ray_capsule.h"
#include "robust/mixed/ray_capsule.h"

namespace touchstone::catalogue::rows {

struct ray_capsule : signatures::ray_capsule {
  TOUCHSTONE_STAGED_MODULES(ray_capsule)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "mixed",
                                     .pages = "9, 23",
                                     .question = "Where does the ray enter and leave the capsule?",
                                     .kind = Kind::measure,
                                     .fields = {"ray", "capsule"},
                                     .ulps = 49,
                                     .margin_degree = 2,
                                     .cost = 4,
                                     .longest_vector = 3000};

  static Question of(const Course& course, const Capsule3d& capsule) {
    return {{course.from, course.displacement}, capsule};
  }
  static bool has_interior(const Capsule3d& capsule) { return capsule.radius > 0; }

  static void hard_cases(HardCases<Question>& add) { line_capsule_cases<ray_capsule>(add); }

  /// Along the cylinder; moves the direction.
  static Question map_centre() { return {{{0, 15, 0}, {16, 0, 0}}, {{{12, 20, 0}, {24, 20, 0}}, 5}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {3, 4}; }

  static Hooks<ray_capsule> hooks() {
    return {.as_open_sets = none_if_grazing<ray_capsule>,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::similarities, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
