// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/meshes/round_convex_draws.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/sphere_convex.h"
#include "oracle/mixed/sphere_convex.h"
#include "reference/mixed/sphere_convex.h"
#include "robust/mixed/sphere_convex.h"
#include "robust/prepared/solid.h"

namespace touchstone::catalogue::rows {

struct sphere_convex : signatures::sphere_convex {
  TOUCHSTONE_STAGED_MODULES(sphere_convex)
  TOUCHSTONE_PREPARED(sphere_convex, ConvexSolid)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "mixed",
                                     .pages = "48-50, 53-54",
                                     .question = "Do a ball and a convex polyhedron overlap, only touch, or neither?",
                                     .kind = Kind::decision,
                                     .fields = {"sphere", "mesh"},
                                     .answer = "contact",
                                     .margin_degree = 2,
                                     .cost = 70,
                                     .time = {.robust = Growth::quadratic,
                                              .oracle = Growth::quadratic,
                                              .ask = Growth::quadratic,
                                              .reference = Growth::linearithmic},
                                     .list_length = 4};

  static void hard_cases(HardCases<Question>& add) {
    add_balls_and_meshes([&add](const char* family, auto draw) { add(family, draw); });
    add_balls_and_long_meshes([&add](const char* family, auto draw) { add.unscaled(family, draw); });
  }

  /// The top of a tetrahedron and the center run over a grid.
  static std::uint64_t domain_count(int size) { return configurations_of_digits(size, 6); }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    const double x = digit(), y = digit(), z = digit(), u = digit(), v = digit(), w = digit();
    const Meshd mesh = tetrahedron_over({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {2 * x, 2 * y, 2 * (z + 1)}}});
    return {{{2 * u + 1, 2 * v, 2 * w}, 2}, mesh};
  }

  /// A ball that reaches the vertex (12, 0, 0); moves its center.
  static Question map_centre() {
    return {{{15, 4, 0}, 5}, tetrahedron_over({{{12, 0, 0}, {-12, 0, 0}, {0, -12, 0}, {0, 0, -12}}})};
  }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static void repair(Question& question) { repair_radii(question), make_tetrahedron(std::get<1>(question)); }

  static Hooks<sphere_convex> hooks() {
    Hooks<sphere_convex> hooks = hooks_of_round_pair<sphere_convex>();
    hooks.repair = repair, hooks.domain_count = domain_count, hooks.domain_at = domain_at;
    return hooks;
  }
};

}  // namespace touchstone::catalogue::rows
