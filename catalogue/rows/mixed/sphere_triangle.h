// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/triangles/round_triangle_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/sphere_triangle.h"
#include "oracle/mixed/sphere_triangle.h"
#include "reference/mixed/sphere_triangle.h"
#include "reference/standard/point_and_triangle.h"
#include "robust/mixed/sphere_triangle.h"

namespace touchstone::catalogue::rows {

struct sphere_triangle : signatures::sphere_triangle {
  TOUCHSTONE_STAGED_MODULES(sphere_triangle)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "mixed",
                                     .pages = "9, 48-50, 54",
                                     .question = "Do a ball and a triangle overlap, only touch, or neither?",
                                     .kind = Kind::decision,
                                     .fields = {"sphere", "triangle"},
                                     .answer = "contact",
                                     .margin_degree = 2,
                                     .cost = 10,
                                     .longest_vector = 2300};

  static void standard(const auto& add) {
    add("foot on the plane, else the nearest edge", [](const auto&... q) {
      return ::touchstone::reference::standard::sphere_triangle<::touchstone::reference::standard::ByFaceOrEdges>(q...);
    });
    add("Ericson, closest point of a triangle, times a reciprocal", [](const auto&... q) {
      return ::touchstone::reference::standard::sphere_triangle<::touchstone::reference::standard::ByRegions>(q...);
    });
  }

  static void hard_cases(HardCases<Question>& add) {
    add_balls_and_triangles([&add](const char* family, auto draw) { add(family, draw); });
  }

  /// A ball that reaches the corner (24, 24, 24) by the triple 3, 4, 5; moves its center.
  static Question map_centre() { return {{{21, 20, 24}, 5}, {{24, 24, 24}, {48, 24, 30}, {30, 48, 24}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<sphere_triangle> hooks() { return hooks_of_round_pair<sphere_triangle>(); }
};

}  // namespace touchstone::catalogue::rows
