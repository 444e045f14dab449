// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/passages/line_capsule_cases.h"
#include "catalogue/operation/open_passages.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/segment_capsule.h"
#include "oracle/mixed/segment_capsule.h"
#include "reference/mixed/segment_capsule.h"
#include "robust/mixed/segment_capsule.h"

namespace touchstone::catalogue::rows {

struct segment_capsule : signatures::segment_capsule {
  TOUCHSTONE_STAGED_MODULES(segment_capsule)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "mixed",
                                     .pages = "23",
                                     .question = "Where does the closed segment enter and leave the capsule?",
                                     .kind = Kind::measure,
                                     .fields = {"segment", "capsule"},
                                     .ulps = 50,
                                     .margin_degree = 2,
                                     .cost = 4,
                                     .longest_vector = 3000};

  static Question of(const Course& course, const Capsule3d& capsule) {
    return {{course.from, course.from + course.displacement}, capsule};
  }
  static bool has_interior(const Capsule3d& capsule) { return capsule.radius > 0; }

  static void hard_cases(HardCases<Question>& add) { line_capsule_cases<segment_capsule>(add); }

  /// Along the cylinder; moves the end.
  static Question map_centre() { return {{{0, 15, 0}, {32, 15, 0}}, {{{12, 20, 0}, {24, 20, 0}}, 5}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {3, 4}; }

  static Hooks<segment_capsule> hooks() {
    return {.as_open_sets = none_if_grazing<segment_capsule>,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::similarities, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
