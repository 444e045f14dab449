// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/ties.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/lines/line_point_at.h"
#include "oracle/lines/line_point_at.h"
#include "reference/lines/line_point_at.h"
#include "robust/lines/line_point_at.h"

namespace touchstone::catalogue::rows {

struct line_point_at : signatures::line_point_at {
  TOUCHSTONE_STAGED_MODULES(line_point_at)

  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "lines",
                                     .pages = "9",
                                     .question = "Which point of the line origin + t direction belongs to t?",
                                     .kind = Kind::measure,
                                     .fields = {"line", "t"},
                                     .answer = "point",
                                     .ulps = 2};

  static void hard_cases(HardCases<Question>& add) {
    add("lattice", [](DrawStream& c) -> Question {
      return {{lattice_point(c), lattice_direction(c)}, integer(c, 20)};
    });
    add("beside_a_tie", [](DrawStream& c) -> Question {
      const NearTie x = near_tie(c);
      return {{{x.rest, 1}, {x.v, 1}}, x.t};
    });
    add("at_zero", [](DrawStream& c) -> Question { return {{lattice_point(c, 53), lattice_direction(c, 53)}, 0.0}; });
    add("cancelling", [](DrawStream& c) -> Question {
      const double t = ordinary(c);
      const Vector2d direction{ordinary(c), 1.0};
      return {{{-(t * direction.x), -t}, direction}, t};
    });
    add("halfway", [](DrawStream& c) -> Question {
      const double x = 0x1p52 + up_to(c, 15);
      return {{{x, -x}, {1.0, up_to(c, 3)}}, 0.5 + integer(c, 3)};
    });
    add("typed_parameter", [](DrawStream& c) -> Question {
      return {{{typed(c), typed(c)}, {typed(c), typed(c)}}, typed(c)};
    });
    add("overflowing", [](DrawStream& c) -> Question {
      // The product is 2^1024 to 1.5 * 2^1024, the origin takes 2^1023 to 2^1024 of it away.
      const double dx = last_binade(c), longer = 1 + std::ldexp(up_to(c, 1023), -11);
      const double t = 0x1p1023 / dx * longer * 2, x = -last_binade(c), sign = either_sign(c);
      return {{{sign * x, integer(c, 53)}, {sign * dx, 1.0}}, t};
    });
    add("far_apart", [](DrawStream& c) -> Question {
      const Point2d origin{ordinary(c), ordinary(c)};
      const double far = std::ldexp(1, -integer_in(c, 0, 127));
      return {{origin, {far * ordinary(c), far * ordinary(c)}}, ordinary(c)};
    });
    add("at_end_of_range", [](DrawStream& c) -> Question {
      const auto [x, dx] = near_largest_double(c);
      const auto [y, dy] = near_largest_double(c);
      const int k = integer_in(c, 0, 63);
      return {{{x, y}, {std::ldexp(dx, -k), std::ldexp(dy, -k)}}, std::ldexp(2, k)};
    });
  }

  /// 2^1023 to the greatest double.
  static double last_binade(DrawStream& c) {
    return std::ldexp(0x1p52 + static_cast<double>(c.below(std::uint64_t{1} << 52)), 971);
  }
  /// An origin and a direction, one axis of each. Twice the direction is (2^52 + q) 2^972, beyond the range; the origin
  /// leaves of it the greatest double and k quarters of a unit in its last place: where k >= 2, infinity is nearest.
  static std::pair<double, double> near_largest_double(DrawStream& c) {
    const double k = 4 - up_to(c, 16), q = static_cast<double>(c.below(std::uint64_t{1} << 49));
    const double sign = either_sign(c);
    return {-sign * std::ldexp(4 - k + 8 * q, 969), sign * std::ldexp(0x1p52 + q, 971)};
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
