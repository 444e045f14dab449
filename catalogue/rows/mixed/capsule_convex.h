// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/meshes/round_convex_draws.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/capsule_convex.h"
#include "oracle/mixed/capsule_convex.h"
#include "reference/mixed/capsule_convex.h"
#include "robust/mixed/capsule_convex.h"
#include "robust/prepared/solid.h"

namespace touchstone::catalogue::rows {

struct capsule_convex : signatures::capsule_convex {
  TOUCHSTONE_STAGED_MODULES(capsule_convex)
  TOUCHSTONE_PREPARED(capsule_convex, ConvexSolid)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "mixed",
      .pages = "9, 48-50, 53-54",
      .question = "Do a capsule and a convex polyhedron overlap, only touch, or neither?",
      .kind = Kind::decision,
      .fields = {"capsule", "mesh"},
      .answer = "contact",
      .margin_degree = 2,
      .cost = 70,
      .time = {.robust = Growth::quadratic,
               .oracle = Growth::quadratic,
               .ask = Growth::quadratic,
               .reference = Growth::linearithmic},
      .list_length = 4};

  static void hard_cases(HardCases<Question>& add) {
    add_capsules_and_meshes([&add](const char* family, auto draw) { add(family, draw); });
    add_balls_and_long_meshes([&add]<class Draw>(const char* family, const Draw&) {
      add.unscaled(family, [](DrawStream& c) -> Question { return ending_in(Draw()(c), c); });
    });
  }

  /// The top of a tetrahedron and one end of the segment run over a grid.
  static std::uint64_t domain_count(int size) { return configurations_of_digits(size, 6); }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    const double x = digit(), y = digit(), z = digit(), u = digit(), v = digit(), w = digit();
    const Meshd mesh = tetrahedron_over({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {2 * x, 2 * y, 2 * (z + 1)}}});
    return {{{{2 * u + 1, 2 * v, 2 * w}, {6, 4, -2}}, 2}, mesh};
  }

  /// A capsule whose end reaches the vertex (12, 0, 0); moves that end.
  static Question map_centre() {
    return {{{{15, 4, 0}, {27, 8, 0}}, 5}, tetrahedron_over({{{12, 0, 0}, {-12, 0, 0}, {0, -12, 0}, {0, 0, -12}}})};
  }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static void repair(Question& question) { repair_radii(question), make_tetrahedron(std::get<1>(question)); }

  static Hooks<capsule_convex> hooks() {
    Hooks<capsule_convex> hooks = hooks_of_round_pair<capsule_convex>();
    hooks.repair = repair, hooks.domain_count = domain_count, hooks.domain_at = domain_at;
    return hooks;
  }
};

}  // namespace touchstone::catalogue::rows
