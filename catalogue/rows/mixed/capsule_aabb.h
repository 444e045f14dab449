// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/round_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/capsule_aabb.h"
#include "oracle/mixed/capsule_aabb.h"
#include "reference/mixed/capsule_aabb.h"
#include "robust/mixed/capsule_aabb.h"

namespace touchstone::catalogue::rows {

struct capsule_aabb : signatures::capsule_aabb {
  TOUCHSTONE_STAGED_MODULES(capsule_aabb)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "mixed",
      .pages = "9, 48-50",
      .question = "Do a capsule and an axis-aligned box overlap, only touch, or neither?",
      .kind = Kind::decision,
      .fields = {"capsule", "aabb"},
      .answer = "contact",
      .margin_degree = 2,
      .cost = 20,
      .longest_vector = 2300};

  static void hard_cases(HardCases<Question>& add) {
    add_capsules_and_aabbs([&add](const char* family, auto draw) { add(family, draw); });
    add.unscaled("negative_radius", [](DrawStream& c) -> Question {
      const auto [capsule, box] = tangent_to_aabb(c);
      return {{capsule.segment, -one_to(c, 3)}, box};
    });
  }

  /// A capsule whose end reaches the corner (16, 16, 16) by the triple 3, 4, 5; moves that end.
  static Question map_centre() { return {{{{19, 20, 16}, {32, 40, 16}}, 5}, {{8, 8, 8}, {16, 16, 16}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static void repair(Question& q) { repair_radii(q), put_in_order(std::get<1>(q)); }

  static Hooks<capsule_aabb> hooks() {
    auto hooks = hooks_of_round_pair<capsule_aabb>();
    hooks.repair = repair, hooks.laws.maps = Laws::Maps::axes;
    return hooks;
  }
};

}  // namespace touchstone::catalogue::rows
