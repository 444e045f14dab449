// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/triangles/round_triangle_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/capsule_triangle.h"
#include "oracle/mixed/capsule_triangle.h"
#include "reference/mixed/capsule_triangle.h"
#include "robust/mixed/capsule_triangle.h"

namespace touchstone::catalogue::rows {

struct capsule_triangle : signatures::capsule_triangle {
  TOUCHSTONE_STAGED_MODULES(capsule_triangle)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "mixed",
                                     .pages = "9, 12-13, 48-50, 54",
                                     .question = "Do a capsule and a triangle overlap, only touch, or neither?",
                                     .kind = Kind::decision,
                                     .fields = {"capsule", "triangle"},
                                     .answer = "contact",
                                     .margin_degree = 2,
                                     .cost = 10,
                                     .longest_vector = 2300};

  static void hard_cases(HardCases<Question>& add) {
    add_capsules_and_triangles([&add](const char* family, auto draw) { add(family, draw); });
    add.unscaled("negative_radius", [](DrawStream& c) -> Question {
      const LatticePlane plane = LatticePlane::of(c, 6);
      const Triangle3d t = plane.triangle(c);
      return {{{plane.point(c), lattice_point_in_space(c, 6)}, -one_to(c, 3)}, t};
    });
  }

  /// A capsule whose end reaches the corner (24, 24, 24) by the triple 3, 4, 5; moves that end.
  static Question map_centre() { return {{{{21, 20, 24}, {8, 4, 24}}, 5}, {{24, 24, 24}, {48, 24, 30}, {30, 48, 24}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<capsule_triangle> hooks() { return hooks_of_round_pair<capsule_triangle>(); }
};

}  // namespace touchstone::catalogue::rows
