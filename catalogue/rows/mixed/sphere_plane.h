// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/half_space_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/sphere_plane.h"
#include "oracle/mixed/sphere_plane.h"
#include "reference/mixed/sphere_plane.h"
#include "robust/mixed/sphere_plane.h"

namespace touchstone::catalogue::rows {

struct sphere_plane : signatures::sphere_plane, OverPlane<Sphere3d> {
  TOUCHSTONE_STAGED_MODULES(sphere_plane)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "mixed",
      .pages = "22, 44",
      .question = "Do a ball and the half-space N . p + d <= 0 behind a plane overlap, only touch, or neither?",
      .kind = Kind::decision,
      .fields = {"sphere", "plane"},
      .answer = "contact",
      .margin_degree = 2};

  static void hard_cases(HardCases<Question>& add) {
    add_balls_over_planes([&add](const char* family, auto draw) { add(family, draw); });
  }

  static void repair(Question& q) { std::get<0>(q).radius = std::fabs(std::get<0>(q).radius); }

  static Hooks<sphere_plane> hooks() {
    return {.as_open_sets = disjoint_if_touching<Question>,
            .repair = repair,
            .scale = scale,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
