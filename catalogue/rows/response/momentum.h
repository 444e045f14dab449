// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/bodies/body_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/response/momentum.h"
#include "oracle/response/momentum.h"
#include "reference/response/momentum.h"
#include "robust/response/momentum.h"

namespace touchstone::catalogue::rows {

struct momentum : signatures::momentum {
  TOUCHSTONE_STAGED_MODULES(momentum)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "response",
                                     .pages = "65",
                                     .question = "Which momentum have these bodies together?",
                                     .kind = Kind::measure,
                                     .fields = {"bodies"},
                                     .answer = "momentum",
                                     .ulps = 16,
                                     .margin_degree = 0,
                                     .time = grows(Growth::linear),
                                     .list_length = 2,
                                     .longest_vector = 3000};

  static void hard_cases(HardCases<Question>& add) { sums_of_bodies<sum_beside_a_tie>(add); }

  /// Velocities: masses keep theirs, so that momentum goes with the velocities.
  static void scale(Question& question, int k) { scale_velocities(question, k); }

  /// It cancels: moves the second velocity's y and z.
  static Question map_centre() { return {{{2, {3, -6, 9}}, {3, {-2, 4, -6}}}}; }

  static void draw(Drawing& drawing, const Question& question, const Vector3d& truth) {
    draw_head_to_tail(drawing, std::get<0>(question), truth);
  }

  static Hooks<momentum> hooks() {
    return {.repair = repair_masses,
            .scale = scale,
            .map_centre = map_centre,
            .draw = draw,
            .laws = {.maps = Laws::Maps::affine, .scales = true}};
  }

 private:
  static Bodies sum_beside_a_tie(DrawStream& c) {
    const NearTie x = near_tie(c);
    const double z = integer(c, 20);
    return {{x.t, {x.v, -x.v, z}}, {1, {x.rest, -x.rest, -z}}};
  }
};

}  // namespace touchstone::catalogue::rows
