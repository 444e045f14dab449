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
  TOUCHSTONE_MODULES(momentum)
  using stages = ::touchstone::robust::stages::momentum;
  using decision = NoDecision;

  static const Metadata& metadata() {
    static const Metadata metadata{.name = name,
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
    return metadata;
  }

  static void hard_cases(HardCases<Question>& add) {
    add("on_lattice", asked<lattice_bodies>);
    add("cancelling", asked<cancelling_bodies>);
    add("far_apart", asked<far_apart_bodies>);
    add("products_at_the_end", asked<bodies_at_the_end>);
    add("at_end_of_range", asked<bodies_at_end_of_range>);
    add("beside_a_tie", asked<sum_beside_a_tie>);
    add("without_a_mass", asked<bodies_without_a_mass>);
    add.unscaled("many_bodies", [](DrawStream& c) -> Question { return {many_bodies(c)}; });
  }

  /// Velocities: masses keep theirs, so that momentum goes with the velocities.
  static void scale(Question& question, int k) {
    for (auto& [mass, v] : std::get<0>(question)) v = {std::ldexp(v.x, k), std::ldexp(v.y, k), std::ldexp(v.z, k)};
  }
  static void repair(Question& question) {
    for (Bodyd& body : std::get<0>(question)) make_positive(body.mass);
  }

  /// It cancels: moves the second velocity's y and z.
  static Question map_centre() { return {{{2, {3, -6, 9}}, {3, {-2, 4, -6}}}}; }

  static void draw(Drawing& drawing, const Question& question, const Vector3d& truth) {
    draw_head_to_tail(drawing, std::get<0>(question), truth);
  }

  static Hooks<momentum> hooks() {
    return {.repair = repair,
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

  template <auto draw>
  static Question asked(DrawStream& c) {
    return {draw(c)};
  }
};

}  // namespace touchstone::catalogue::rows
