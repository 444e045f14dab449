// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/ties.h"
#include "catalogue/operation/row.h"
#include "oracle/lines/line_point_at.h"
#include "reference/lines/line_point_at.h"
#include "robust/lines/line_point_at.h"

namespace touchstone::catalogue::rows {

struct line_point_at {
  TOUCHSTONE_MODULES(line_point_at)
  using stages = ::touchstone::robust::stages::line_point_at;
  using Question = std::tuple<ParametricLine2d, double>;

  using decision = NoDecision;

  static const Card& card() {
    static const Card card{.name = "line_point_at",
                           .chapter = "lines",
                           .pages = "9",
                           .question = "Which point of the line origin + t direction belongs to t?",
                           .kind = Kind::measure,
                           .fields = {"line", "t"},
                           .answer = "point",
                           .ulps = 2};
    return card;
  }

  static std::vector<HardCase<Question>> hard_cases() {
    return {
        {"lattice",
         [](Choices& c) -> Question {
           const Point2d origin = lattice_point(c);
           return {{origin, lattice_direction(c)}, integer(c, 20)};
         }},
        {"beside_a_tie",
         [](Choices& c) -> Question {
           const BesideTie x = beside_tie(c);
           return {{{x.rest, 1}, {x.v, 1}}, x.t};
         }},
        {"at_zero",
         [](Choices& c) -> Question {
           const Point2d origin = lattice_point(c, 53);
           return {{origin, lattice_direction(c, 53)}, 0.0};
         }},
        {"cancelling",
         [](Choices& c) -> Question {
           const double t = ordinary(c);
           const Vector2d direction{ordinary(c), 1.0};
           return {{{-(t * direction.x), -t}, direction}, t};
         }},
        {"halfway",
         [](Choices& c) -> Question {
           const double x = 0x1p52 + static_cast<double>(c.below(16));
           return {{{x, -x}, {1.0, static_cast<double>(c.below(4))}}, 0.5 + integer(c, 3)};
         }},
        {"typed_parameter",
         [](Choices& c) -> Question {
           return {{{typed(c), typed(c)}, {typed(c), typed(c)}}, typed(c)};
         }},
        {"overflowing",
         [](Choices& c) -> Question {
           const Point2d origin{std::ldexp(integer(c, 53), 971), integer(c, 53)};
           const double dx = std::ldexp(small_integer(c) + 0.5, 1000), t = small_integer(c);
           return {{origin, {dx, 1.0}}, std::ldexp(t, static_cast<int>(c.below(30)))};
         }},
        {"far_apart",
         [](Choices& c) -> Question {
           const Point2d origin{ordinary(c), ordinary(c)};
           const double far = std::ldexp(1, -static_cast<int>(c.below(128)));
           return {{origin, {far * ordinary(c), far * ordinary(c)}}, ordinary(c)};
         }},
        {"at_end_of_range",
         [](Choices& c) -> Question {
           const double x = ordinary(c), y = ordinary(c);
           return {{{integer(c, 53), 0.0}, {std::ldexp(x, 1023), std::ldexp(y, 1023)}}, 8 * ordinary(c)};
         }},
    };
  }

  /// t counts in lengths of the direction: it keeps its value.
  static void scale(Question& question, int k) {
    auto& [origin, direction] = std::get<0>(question);
    origin = {std::ldexp(origin.x, k), std::ldexp(origin.y, k)};
    direction = {std::ldexp(direction.x, k), std::ldexp(direction.y, k)};
  }

  /// x is near 0 by cancellation at t = 1/3; moves x of the origin and t.
  static Question map_centre() { return {{{-1, -12}, {3, 3}}, 1.0 / 3}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 4}; }

  static Hooks<line_point_at> hooks() {
    return {.scale = scale,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::affine, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
