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
  TOUCHSTONE_MODULES(kinetic_energy)
  using stages = ::touchstone::robust::stages::kinetic_energy;
  using decision = NoDecision;

  static const Metadata& metadata() {
    static const Metadata metadata{.name = name,
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

  static void scale(Question& question, int k) {
    for (auto& [mass, v] : std::get<0>(question)) v = {std::ldexp(v.x, k), std::ldexp(v.y, k), std::ldexp(v.z, k)};
  }
  static void repair(Question& question) {
    for (Bodyd& body : std::get<0>(question)) make_positive(body.mass);
  }

  /// Nothing moves: moves the second velocity's y and z.
  static Question map_centre() { return {{{2, {0, 0, 0}}, {3, {0, 0, 0}}}}; }

  static void draw(Drawing& drawing, const Question& question, const double&) {
    draw_in_a_row(drawing, std::get<0>(question));
  }

  static Hooks<kinetic_energy> hooks() {
    return {
        .repair = repair, .scale = scale, .map_centre = map_centre, .draw = draw, .laws = {.maps = Laws::Maps::axes}};
  }

 private:
  /// An integer of 53 digits, and a half, or one unit in the last place less; and perhaps something beyond all digits.
  static Bodies sum_beside_a_tie(DrawStream& c) {
    const double whole = 0x1p52 + static_cast<double>(c.below(std::uint64_t{1} << 51));
    Bodies list{{2 * whole, {0, -1, 0}}, {c.coin() ? 1 - 0x1p-53 : 1, {1, 0, 0}}};
    if (c.coin()) list.push_back({1, {0, 0, std::ldexp(1, -integer_in(c, 0, 199))}});
    return list;
  }

  template <auto draw>
  static Question asked(DrawStream& c) {
    return {draw(c)};
  }
};

}  // namespace touchstone::catalogue::rows
