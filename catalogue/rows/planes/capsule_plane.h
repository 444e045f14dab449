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

struct capsule_plane : signatures::capsule_plane, OverHalfSpace<Capsule3d> {
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
        const Point3d &p = ball.center, q = beyond(c, p, plane.normal);
        const bool first = c.coin();
        return {{{first ? p : q, first ? q : p}, ball.radius}, plane};
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

 private:
  /// The other end: the same point, one as high, higher, lower, or far from there.
  static Point3d beyond(DrawStream& c, const Point3d& p, const Vector3d& n) {
    const double steps = small_integer(c, 3);
    const Vector3d across = lattice_across(c, n);
    switch (c.below(4)) {
      case 0: return p + across;
      case 1: return p + (across + std::fabs(steps) * n);
      case 2: return p + (across + steps * n);
      default: return lattice_point_in_space(c);
    }
  }
};

}  // namespace touchstone::catalogue::rows
