// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/passages/capsule_pairs.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/capsule_capsule.h"
#include "oracle/mixed/capsule_capsule.h"
#include "reference/mixed/capsule_capsule.h"
#include "reference/standard/pair_of_segments.h"
#include "robust/batch/capsule_capsule.h"
#include "robust/mixed/capsule_capsule.h"

namespace touchstone::catalogue::rows {

struct capsule_capsule : signatures::capsule_capsule {
  TOUCHSTONE_STAGED_MODULES(capsule_capsule)
  TOUCHSTONE_ARRAYS(capsule_capsule)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "mixed",
                                     .pages = "9, 12-13, 44",
                                     .question = "Do two capsules overlap, only touch, or neither?",
                                     .kind = Kind::decision,
                                     .fields = {"a", "b"},
                                     .answer = "contact",
                                     .margin_degree = 2,
                                     .cost = 20,
                                     .longest_vector = 2300};

  static void standard(const auto& add) {
    add("Ericson, closest points of segments", [](const auto&... q) {
      return ::touchstone::reference::standard::capsule_capsule<::touchstone::reference::standard::ByClamping>(q...);
    });
    add("Eberly, robust closest points of segments", [](const auto&... q) {
      return ::touchstone::reference::standard::capsule_capsule<::touchstone::reference::standard::OnSquare>(q...);
    });
  }

  static void hard_cases(HardCases<Question>& add) {
    add_pairs_of_capsules([&add](const char* family, auto draw) { add(family, draw); });
  }

  /// Capsules whose ends reach each other by the triple 3, 4, 5; moves the first.
  static Question map_centre() { return {{{{21, 20, 24}, {3, 12, 24}}, 3}, {{{24, 24, 24}, {48, 36, 24}}, 2}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<capsule_capsule> hooks() { return hooks_of_round_pair<capsule_capsule>({{0, 1}}); }
};

}  // namespace touchstone::catalogue::rows
