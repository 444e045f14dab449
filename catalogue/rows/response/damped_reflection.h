// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/bodies/bounce_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/response/damped_reflection.h"
#include "oracle/response/damped_reflection.h"
#include "reference/response/damped_reflection.h"
#include "robust/response/damped_reflection.h"

namespace touchstone::catalogue::rows {

struct damped_reflection : signatures::damped_reflection {
  TOUCHSTONE_STAGED_MODULES(damped_reflection)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "response",
      .pages = "71",
      .question = "Which velocity has a body after a bounce that leaves k of its speed along the normal?",
      .kind = Kind::measure,
      .fields = {"velocity", "normal", "k"},
      .answer = "velocity",
      .ulps = 15,
      .margin_degree = 0,
      .longest_vector = 3000};

  static void hard_cases(HardCases<Question>& add) {
    add("on_lattice", asked<lattice_bounce, usual>);
    add("along_the_plane", asked<along_the_plane, usual>);
    add("grazing", asked<grazing, usual>);
    add("straight", asked<straight, usual>);
    add("nothing_lost", asked<across_an_axis, near_minus_one>);
    add("stretched_normal", asked<stretched_bounce, usual>);
    add("products_at_the_end", asked<products_at_the_end, any_size>);
    add("at_end_of_range", asked<at_end_of_range, usual>);
    add("beside_a_tie", asked<bounce_beside_a_tie, one>);
    add("without_a_normal", asked<without_a_normal, usual>);
  }

  /// k has no unit: it keeps its value.
  static void scale(Question& question, int exponent) {
    auto& [v, n, k] = question;
    for (Vector3d* vector : {&v, &n})
      *vector = {std::ldexp(vector->x, exponent), std::ldexp(vector->y, exponent), std::ldexp(vector->z, exponent)};
  }

  /// Nothing is left along the normal: moves the velocity's y and k.
  static Question map_centre() { return {{3, 1, 0}, {1, 3, 0}, 0}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {1, 6}; }

  static void draw(Drawing& drawing, const Question& question, const Vector3d& truth) {
    const auto& [velocity, normal, k] = question;
    draw_bounce(drawing, velocity, normal, truth);
    drawing.notes.push_back("k = " + decimal(k));
  }

  static Hooks<damped_reflection> hooks() {
    return {.scale = scale,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .draw = draw,
            .laws = {.maps = Laws::Maps::similarities, .scales = true}};
  }

 private:
  static double usual(DrawStream& c) {
    switch (c.below(4)) {
      case 0: return 0.8;
      case 1: return small_integer(c, 2);
      case 2: return up_to(c, 16) / 16;
      default: return typed(c);
    }
  }
  static double one(DrawStream&) { return 1; }
  /// 1 + k is 0, or all its digits are cancelled but the last.
  static double near_minus_one(DrawStream& c) { return ulps_apart(c, -1, 3); }
  static double any_size(DrawStream& c) {
    const int exponent = integer_in(c, -600, 599);
    return std::ldexp(ordinary(c), exponent);
  }

  template <auto draw, auto draw_k>
  static Question asked(DrawStream& c) {
    const Bounce b = draw(c);
    return {b.velocity, b.normal, draw_k(c)};
  }
};

}  // namespace touchstone::catalogue::rows
