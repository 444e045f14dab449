// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/passages/obb_pairs.h"
#include "catalogue/families/ties.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/sweeps/swept_obb_obb.h"
#include "oracle/sweeps/swept_obb_obb.h"
#include "reference/sweeps/swept_obb_obb.h"
#include "robust/sweeps/swept_obb_obb.h"

namespace touchstone::catalogue::rows {

struct swept_obb_obb : signatures::swept_obb_obb {
  TOUCHSTONE_STAGED_MODULES(swept_obb_obb)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "sweeps",
      .pages = "27, 51",
      .question = "When in a step does a moving oriented box first have a common point with one at rest?",
      .kind = Kind::measure,
      .fields = {"a", "b", "velocity"},
      .ulps = 23,
      .margin_degree = 2,
      .cost = 20};

  static void hard_cases(HardCases<Question>& add) {
    add("slides_along", [](DrawStream& c) -> Question {
      // Along a face of a that touches b, or an edge; from a step or two before it.
      auto [a, b] = touching_obbs(c, lattice_half_axes);
      const std::array<Vector3d*, 3> axes = each_of(a.half_axes);
      const double i = small_integer(c, 3), j = small_integer(c, 3), before = up_to(c, 2);
      const Vector3d &one = *axes[c.below(3)], &other = *axes[c.below(3)], way = i * one + j * other;
      return {moved(a, -before * way), b, 4.0 * way};
    });
    add("through", [](DrawStream& c) -> Question {
      // From one side to the other: they meet neither at the start nor at the end.
      const Obb3d a = lattice_obb(c);
      Obb3d b = lattice_obb(c);
      b.center = a.center;
      const Vector3d way = 64.0 * lattice_normal(c, 3), aside = lattice_normal(c, 3);
      const double off = small_integer(c, 2);
      return {moved(moved(a, -1.0 * way), off * aside), b, up_to(c, 2) * way};
    });
    add("at_end", [](DrawStream& c) -> Question {
      const auto [a, b] = touching_obbs(c, c.coin() ? turned_half_axes : lattice_half_axes);
      const Vector3d way = lattice_normal(c, 6);
      return {moved(a, -1.0 * way), b, way};
    });
    add("beside_a_tie", [](DrawStream& c) -> Question {
      const auto [low, high, fall] = way_beside_tie(c);
      const double turn = small_integer(c, 2);
      return {{{0, high, 0}, {{1, 0, 0}, {0, 1, 0}, {turn, 0, 1}}},
              {{0, -2 - low, 0}, {{2, 0, 0}, {0, 1, 0}, {0, 0, 2}}},
              {0, -fall * 0x1p54, 0}};
    });
    // Before, after or at the place of a next to b.
    add_pairs_of_obbs([&add]<class Draw>(const char* family, const Draw&) {
      add(family, [](DrawStream& c) -> Question {
        const auto [a, b] = Draw()(c);
        const Vector3d way = lattice_normal(c, 4);
        const double before = up_to(c, 2), steps = up_to(c, 3);
        return {moved(a, -before * way), b, steps * way};
      });
    });
  }

  /// A corner of a ahead of the side of b that it moves to; moves a.
  static Question map_centre() {
    return {{{-4, 0.5, 0}, {{3, 4, 0}, {-4, 3, 0}, {0, 0, 1}}},
            {{12, 0, 0}, {{4, 0, 0}, {0, 4, 0}, {0, 0, 1}}},
            {10, 0, 0}};
  }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  /// The step: a at its start, at the first contact and at its end.
  static void draw(Drawing& drawing, const Question& question, const FirstContact<double>& truth) {
    const auto& [a, b, velocity] = question;
    draw_sweep(drawing, "a", a, velocity, truth.t);
    ::touchstone::catalogue::draw(drawing, "b", b, false);
  }

  static Hooks<swept_obb_obb> hooks() {
    return {.as_open_sets = never_if_grazing<swept_obb_obb>,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .draw = draw,
            .laws = {.maps = Laws::Maps::affine, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
