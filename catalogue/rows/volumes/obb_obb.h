// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/passages/obb_pairs.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/volumes/obb_obb.h"
#include "oracle/volumes/obb_obb.h"
#include "reference/standard/oriented_boxes.h"
#include "reference/volumes/obb_obb.h"
#include "robust/batch/obb_obb.h"
#include "robust/volumes/obb_obb.h"

namespace touchstone::catalogue::rows {

struct obb_obb : signatures::obb_obb {
  TOUCHSTONE_STAGED_MODULES(obb_obb)
  TOUCHSTONE_ARRAYS(obb_obb)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "volumes",
                                     .pages = "27",
                                     .question = "Do the two oriented boxes overlap, only touch, or neither?",
                                     .kind = Kind::decision,
                                     .fields = {"a", "b"},
                                     .answer = "contact",
                                     .margin_degree = 2,
                                     .cost = 10};

  static void standard(const auto& add) {
    add("Gottschalk, in the frame of the first box",
        [](const auto&... q) { return ::touchstone::reference::standard::obb_obb(q...); });
  }

  static void hard_cases(HardCases<Question>& add) {
    add_pairs_of_obbs([&add](const char* family, auto draw) { add(family, draw); });
  }

  /// A corner of a rotated box on a side of a straight one.
  static Question map_centre() {
    return {{{0.5, 0.5, 0}, {{4, 0, 0}, {0, 4, 0}, {0, 0, 1}}}, {{11.5, 1.5, 0}, {{3, 4, 0}, {-4, 3, 0}, {0, 0, 1}}}};
  }
  static std::pair<std::size_t, std::size_t> map_axes() { return {12, 13}; }

  /// a is a cube: every two boxes are images of such under an affine map. The center of b is three times as far from
  /// that of a as the numbers say, so that the boxes part.
  static std::uint64_t domain_count(int size) { return configurations_of_digits(size, 12); }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    Obb3d b{};
    for (double* x : {&b.center.x, &b.center.y, &b.center.z}) *x = 3 * digit();
    for (Vector3d* axis : each_of(b.half_axes)) {
      const double x = digit(), y = digit();
      *axis = {x, y, digit()};
    }
    return {{{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, b};
  }

  static Hooks<obb_obb> hooks() {
    return {.as_open_sets = disjoint_if_touching<Question>,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .domain_count = domain_count,
            .domain_at = domain_at,
            .laws = {.maps = Laws::Maps::affine, .scales = true, .exchanges = {{0, 1}}}};
  }
};

}  // namespace touchstone::catalogue::rows
