// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/bodies/body_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/response/kinetic_energy.h"
#include "oracle/response/kinetic_energy.h"
#include "reference/response/kinetic_energy.h"
#include "robust/response/kinetic_energy.h"

namespace touchstone::catalogue::rows {

struct kinetic_energy : signatures::kinetic_energy {
  TOUCHSTONE_STAGED_MODULES(kinetic_energy)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "response",
                                     .pages = "66",
                                     .question = "Which kinetic energy have these bodies together?",
                                     .kind = Kind::measure,
                                     .fields = {"bodies"},
                                     .answer = "energy",
                                     .ulps = 56,
                                     .margin_degree = 0,
                                     .time = grows(Growth::linear),
                                     .list_length = 2,
                                     .longest_vector = 3000};

  static void hard_cases(HardCases<Question>& add) { sums_of_bodies<sum_beside_a_tie>(add); }

  static void scale(Question& question, int k) { scale_velocities(question, k); }

  /// Nothing moves: moves the second velocity's y and z.
  static Question map_centre() { return {{{2, {0, 0, 0}}, {3, {0, 0, 0}}}}; }

  static void draw(Drawing& drawing, const Question& question, const double&) {
    draw_in_a_row(drawing, std::get<0>(question));
  }

  static Hooks<kinetic_energy> hooks() {
    return {.repair = repair_masses,
            .scale = scale,
            .map_centre = map_centre,
            .draw = draw,
            .laws = {.maps = Laws::Maps::axes}};
  }

 private:
  /// An integer of 53 digits, and a half, or one unit in the last place less; and perhaps something beyond all digits.
  static Bodies sum_beside_a_tie(DrawStream& c) {
    const double whole = 0x1p52 + static_cast<double>(c.below(std::uint64_t{1} << 51));
    Bodies list{{2 * whole, {0, -1, 0}}, {c.coin() ? 1 - 0x1p-53 : 1, {1, 0, 0}}};
    if (c.coin()) list.push_back({1, {0, 0, std::ldexp(1, -integer_in(c, 0, 199))}});
    return list;
  }
};

}  // namespace touchstone::catalogue::rows
