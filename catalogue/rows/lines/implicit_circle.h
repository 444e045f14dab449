// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/lines/implicit_circle.h"
#include "oracle/lines/implicit_circle.h"
#include "reference/lines/implicit_circle.h"
#include "robust/lines/implicit_circle.h"
#include "robust/lines/parametric_circle.h"

namespace touchstone::catalogue::rows {

struct implicit_circle : signatures::implicit_circle {
  TOUCHSTONE_STAGED_MODULES(implicit_circle)

  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "lines",
      .pages = "8",
      .question = "Is the point inside, on or outside the circle (x - cx)^2 + (y - cy)^2 = r^2?",
      .kind = Kind::decision,
      .fields = {"circle", "point"},
      .answer = "location",
      .margin_degree = 2};

  static void hard_cases(HardCases<Question>& add) {
    add("on_circle", [](DrawStream& c) -> Question {
      const auto& t = triples[c.below(std::size(triples))];
      const double k = one_to(c, 1 << 15), flip = either_sign(c);
      const Point2d center = lattice_point(c);
      const bool swapped = c.coin();
      const double dx = k * t[swapped ? 1 : 0], dy = flip * k * t[swapped ? 0 : 1];
      return {{center, k * t[2]}, {center.x + dx, center.y + dy}};
    });
    add("beside_circle", [](DrawStream& c) -> Question {
      const auto& t = triples[c.below(std::size(triples))];
      const double k = one_to(c, 1 << 15);
      const Point2d center = lattice_point(c);
      return {{center, k * t[2]}, {center.x + k * t[0] + small_integer(c, 1), center.y - k * t[1]}};
    });
    add("radius_zero", [](DrawStream& c) -> Question {
      const Point2d center = lattice_point(c);
      return {{center, 0.0}, {center.x + small_integer(c, 1), center.y + small_integer(c, 1)}};
    });
    add("point_at_centre", [](DrawStream& c) -> Question {
      const Point2d center = lattice_point(c, 53);
      return {{center, std::fabs(integer(c, 53))}, center};
    });
    add("axis_point", [](DrawStream& c) -> Question {
      const Point2d center = lattice_point(c, 50);
      const double r = std::fabs(integer(c, 50));
      return {{center, r}, {c.coin() ? center.x - r : center.x + r, center.y}};
    });
    add("rounded_on_circle", [](DrawStream& c) -> Question {
      const double r = std::fabs(typed(c)), u = 8 * ordinary(c);
      const Point2d center{typed(c), typed(c)};
      const Point2d at = robust::parametric_circle({{0, 0}, 1}, u);
      return {{center, r}, {center.x + r * at.x, center.y + r * at.y}};
    });
    add("on_long_circle", [](DrawStream& c) -> Question {
      // A multiple of 3, 4, 5 whose squares do not fit a double.
      const double w = std::ldexp(1, 49) + static_cast<double>(c.below(std::uint64_t{1} << 49));
      const Point2d p{c.coin() ? -3 * w : 3 * w, c.coin() ? -4 * w : 4 * w};
      return {{{0, 0}, 5 * w}, c.coin() ? Point2d{p.y, p.x} : p};
    });
    add("past_half_the_bound", [](DrawStream& c) -> Question {
      // Outside by the height alone. Rounded upwards the distance along x shrinks to 1, and the radius' square
      // grows: by 3 units in the last place of 1 together, where the filter's bound is 5. That takes FTZ, which
      // loses the height's square, without DAZ, which would lose the centre's x.
      return {{{-0x1p-1074, 0.0}, 1 + 0x1p-52}, {-(1 + 0x1p-52), std::ldexp(1, -512 - integer_in(c, 0, 24))}};
    });
  }

  /// Legs and hypotenuse of right triangles with integer sides: points on circles, exactly.
  static constexpr int triples[][3] = {{3, 4, 5},   {0, 1, 1},    {5, 12, 13},     {8, 15, 17},
                                       {7, 24, 25}, {20, 21, 29}, {119, 120, 169}, {12, 35, 37}};

  /// The point (12.5, 5.5) of a circle by the triple 5, 12, 13; moves the centre.
  static Question map_centre() { return {{{0.5, 0.5}, 13}, {12.5, 5.5}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<implicit_circle> hooks() {
    return {.as_open_sets = outside_if_on_boundary<Question>,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::similarities, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
