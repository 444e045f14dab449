// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/half_space_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/planes/capsule_plane.h"
#include "oracle/planes/capsule_plane.h"
#include "reference/planes/capsule_plane.h"
#include "robust/planes/capsule_plane.h"

namespace touchstone::catalogue::rows {

struct capsule_plane : signatures::capsule_plane, OverPlane<Capsule3d> {
  TOUCHSTONE_STAGED_MODULES(capsule_plane)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "planes",
      .pages = "22, 44",
      .question = "Do a capsule and the half-space N . p + d <= 0 behind a plane overlap, only touch, or neither?",
      .kind = Kind::decision,
      .fields = {"capsule", "plane"},
      .answer = "contact",
      .margin_degree = 2};

  static void hard_cases(HardCases<Question>& add) {
    add_balls_over_planes([&add]<class Draw>(const char* family, Draw) {
      add(family, [](DrawStream& c) -> Question {
        const auto [ball, plane] = Draw{}(c);
        return {with_end(c, ball, plane.normal), plane};
      });
    });
  }

  static void repair(Question& q) { std::get<0>(q).radius = std::fabs(std::get<0>(q).radius); }

  static Hooks<capsule_plane> hooks() {
    return {.as_open_sets = disjoint_if_touching<Question>,
            .repair = repair,
            .scale = scale,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
