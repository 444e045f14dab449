// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/figures.h"
#include "catalogue/numbers/fused.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/lines/explicit_line.h"
#include "oracle/lines/explicit_line.h"
#include "reference/lines/explicit_line.h"
#include "robust/lines/explicit_line.h"

namespace touchstone::catalogue::rows {

struct explicit_line : signatures::explicit_line {
  TOUCHSTONE_STAGED_MODULES(explicit_line)

  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "lines",
                                     .pages = "8",
                                     .question = "Is the point above, on or below the line y = slope x + intercept?",
                                     .kind = Kind::decision,
                                     .fields = {"slope", "intercept", "point"},
                                     .answer = "side"};

  static void hard_cases(HardCases<Question>& add) {
    add("on_line", [](DrawStream& c) -> Question {
      const double slope = integer(c, 20), intercept = integer(c, 26), x = integer(c, 26);
      return {slope, intercept, {x, slope * x + intercept}};
    });
    add("beside_line", [](DrawStream& c) -> Question {
      const double slope = integer(c, 20), intercept = integer(c, 26), x = integer(c, 26);
      return {slope, intercept, {x, slope * x + intercept + small_integer(c, 1)}};
    });
    add("flat", [](DrawStream& c) -> Question {
      const double intercept = integer(c, 53);
      return {0.0, intercept, {integer(c, 53), c.coin() ? intercept : integer(c, 53)}};
    });
    add("through_origin", [](DrawStream& c) -> Question {
      const double slope = integer(c, 26), x = integer(c, 26);
      return {slope, 0.0, {x, slope * x}};
    });
    add("rounded_on_line", [](DrawStream& c) -> Question {
      const double slope = typed(c), intercept = typed(c), x = typed(c);
      return {slope, intercept, {x, slope * x + intercept}};
    });
    add("cancelling", [](DrawStream& c) -> Question {
      const double slope = ordinary(c), x = ordinary(c);
      return {slope, -(slope * x), {x, c.coin() ? fused(slope, x, -(slope * x)) : 0.0}};
    });
  }

  /// The slope is a ratio of lengths: it keeps its value.
  static void scale(Question& question, int k) {
    auto& [slope, intercept, point] = question;
    intercept = std::ldexp(intercept, k);
    point = {std::ldexp(point.x, k), std::ldexp(point.y, k)};
  }

  static void draw(Drawing& drawing, const Question& question, const Height&) {
    const auto& [slope, intercept, point] = question;
    const double x0 = point.x - 1, x1 = point.x + 1;
    drawing.figures.push_back({Figure::Kind::line,
                               "y = slope x + intercept",
                               {x0, slope * x0 + intercept, x1, slope * x1 + intercept},
                               false});
    catalogue::draw(drawing, "point", point, false);
  }

  /// The point (0.5, 12.25) of y = x / 2 + 12: moves the slope and x, whose product is far finer than y.
  static Question map_centre() { return {0.5, 12, {0.5, 12.25}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 2}; }

  static Hooks<explicit_line> hooks() {
    return {.scale = scale, .map_centre = map_centre, .map_axes = map_axes, .draw = draw, .laws = {.scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
