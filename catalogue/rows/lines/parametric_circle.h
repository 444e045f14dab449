// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/operation/row.h"
#include "catalogue/signatures/lines/parametric_circle.h"
#include "oracle/lines/parametric_circle.h"
#include "reference/lines/parametric_circle.h"
#include "robust/lines/parametric_circle.h"

namespace touchstone::catalogue::rows {

struct parametric_circle : signatures::parametric_circle {
  TOUCHSTONE_STAGED_MODULES(parametric_circle)

  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "lines",
      .pages = "8",
      .question = "Which point of the circle belongs to the parameter u (radians from +x, counter-clockwise)?",
      .kind = Kind::measure,
      .fields = {"circle", "u"},
      .answer = "point",
      .ulps = 3};

  static void hard_cases(HardCases<Question>& add) {
    add("at_zero", [](DrawStream& c) -> Question {
      return {{lattice_point(c, 53), std::fabs(integer(c, 53))}, zero(c)};
    });
    add("radius_zero", [](DrawStream& c) -> Question { return {{lattice_point(c, 53), 0.0}, integer(c, 53)}; });
    add("near_quarter_turns", [](DrawStream& c) -> Question {
      static constexpr double quarter = 0x1.921fb54442d18p+0;  // the double nearest to pi / 2
      const double turns = small_integer(c, 64);
      return {{lattice_point(c), one_to(c, 64)}, turns * quarter};
    });
    add("huge_angle", [](DrawStream& c) -> Question {
      const double u = one_to(c, 1 << 20);
      const int exponent = integer_in(c, 0, 999);
      return {{lattice_point(c), one_to(c, 64)}, std::ldexp(u, exponent)};
    });
    add("tiny_angle", [](DrawStream& c) -> Question {
      const double u = small_integer(c);
      const int exponent = -integer_in(c, 0, 1069);
      return {{lattice_point(c), one_to(c, 64)}, std::ldexp(u, exponent)};
    });
    add("cancelling", [](DrawStream& c) -> Question {
      const double r = one_to(c, 1 << 20), u = 8 * ordinary(c);
      const Point2d at = robust::parametric_circle({{0, 0}, 1}, u);
      return {{{-r * at.x, -r * at.y}, r}, u};
    });
    add("typed_angle", [](DrawStream& c) -> Question {
      return {{{typed(c), typed(c)}, std::fabs(typed(c))}, typed(c)};
    });
  }

  /// The angle is no length: it keeps its value.
  static void scale(Question& question, int k) {
    auto& circle = std::get<0>(question);
    circle = {{std::ldexp(circle.center.x, k), std::ldexp(circle.center.y, k)}, std::ldexp(circle.radius, k)};
  }

  /// The unit circle at a quarter turn: moves the radius and the angle.
  static Question map_centre() { return {{{0, 0}, 1}, 0x1.921fb54442d18p+0}; }

  static Hooks<parametric_circle> hooks() { return {.scale = scale, .map_centre = map_centre}; }
};

}  // namespace touchstone::catalogue::rows
