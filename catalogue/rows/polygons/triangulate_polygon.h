// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/ring_cases.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/polygons/triangulate_polygon.h"
#include "oracle/polygons/triangulate_polygon.h"
#include "reference/polygons/triangulate_polygon.h"
#include "robust/polygons/triangulate_polygon.h"

namespace touchstone::catalogue::rows {

struct triangulate_polygon : signatures::triangulate_polygon {
  TOUCHSTONE_STAGED_MODULES(triangulate_polygon)

  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "polygons",
                                     .pages = "7",
                                     .question = "Which triangles, corners at its vertices, make up a simple polygon?",
                                     .kind = Kind::checked,
                                     .fields = {"polygon"},
                                     .answer = "triangles",
                                     .margin_degree = 2,
                                     .cost = 6,
                                     .time = {.robust = Growth::linearithmic,
                                              .oracle = Growth::quadratic,
                                              .ask = Growth::quadratic,
                                              .reference = Growth::cubic},
                                     .list_length = 4};

  static void hard_cases(HardCases<Question>& add) { simple_ring_cases(add); }
  static void repair(Question& question) { untangle(std::get<0>(question)); }

  static std::string defect(const Question& question, const std::vector<std::vector<Index>>& triangles) {
    return ::touchstone::oracle::triangulate_polygon_defect(std::get<0>(question), triangles);
  }

  /// The classroom example of orientation as a ring: is the first vertex flat?
  static Question map_centre() { return {{{{12, 12}, {24, 24}, {0, 24}, {0.5, 0.5}}}}; }

  static Hooks<triangulate_polygon> hooks() {
    return {
        .defect = defect, .excess = excess_of_pieces, .repair = repair, .map_centre = map_centre, .draw = draw_pieces};
  }
};

}  // namespace touchstone::catalogue::rows
