// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/ring_cases.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/polygons/convex_partition.h"
#include "oracle/polygons/convex_partition.h"
#include "reference/polygons/convex_partition.h"
#include "robust/polygons/convex_partition.h"

namespace touchstone::catalogue::rows {

struct convex_partition : signatures::convex_partition {
  TOUCHSTONE_STAGED_MODULES(convex_partition)

  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "polygons",
      .pages = "7",
      .question = "Which convex pieces, corners at its vertices, make up a simple polygon?",
      .kind = Kind::checked,
      .fields = {"polygon"},
      .answer = "pieces",
      .margin_degree = 2,
      .cost = 6,
      .time = {.robust = Growth::linearithmic,
               .oracle = Growth::quadratic,
               .ask = Growth::quadratic,
               .reference = Growth::cubic},
      .list_length = 4};

  static void hard_cases(HardCases<Question>& add) { simple_ring_cases(add); }
  static void repair(Question& question) { untangle(std::get<0>(question)); }

  static std::string defect(const Question& question, const std::vector<std::vector<Index>>& pieces) {
    return ::touchstone::oracle::convex_partition_defect(std::get<0>(question), pieces);
  }

  /// The classroom example of orientation as a ring: is the first vertex flat?
  static Question map_centre() { return {{{{12, 12}, {24, 24}, {0, 24}, {0.5, 0.5}}}}; }

  static Hooks<convex_partition> hooks() {
    return {
        .defect = defect, .excess = excess_of_pieces, .repair = repair, .map_centre = map_centre, .draw = draw_pieces};
  }
};

}  // namespace touchstone::catalogue::rows
