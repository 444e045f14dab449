// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/rounded_draws.h"
#include "catalogue/families/ties.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/lines/line_line.h"
#include "oracle/lines/line_line.h"
#include "reference/lines/line_line.h"
#include "robust/lines/line_line.h"

namespace touchstone::catalogue::rows {

struct line_line : signatures::line_line {
  TOUCHSTONE_STAGED_MODULES(line_line)

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "lines",
                                     .pages = "12",
                                     .question = "Where do the lines through two points each cross?",
                                     .kind = Kind::set,
                                     .fields = {"a", "b"},
                                     .ulps = 15,
                                     .margin_degree = 2};

  struct decision {
    static LineRelation robust(const Question& q) {
      return ::touchstone::robust::line_line_relation(std::get<0>(q), std::get<1>(q));
    }
  };

  static void hard_cases(HardCases<Question>& add) {
    add("crossing_on_lattice", [](DrawStream& c) -> Question {
      const Point2d p = lattice_point(c);
      const Vector2d u = lattice_direction(c), v = lattice_direction(c);
      return {{along(p, small_integer(c, 4), u), along(p, 5, u)}, {along(p, small_integer(c, 4), v), along(p, 5, v)}};
    });
    add("beside_a_tie", [](DrawStream& c) -> Question {
      const auto [d, q] = quotient_near_tie(c);
      return {{{0, 0}, {0, d}}, {{2 * d, d + 1}, {2 * d - 1, d + 1 + q}}};
    });
    add("parallel", [](DrawStream& c) -> Question {
      const Point2d p = lattice_point(c), q = lattice_point(c);
      const Vector2d v = lattice_direction(c);
      return {{p, along(p, one_to(c, 8), v)}, {q, along(q, -one_to(c, 8), v)}};
    });
    add("same", [](DrawStream& c) -> Question {
      const auto [p, v] = lattice_line(c);
      return {{p, along(p, one_to(c, 4), v)}, {along(p, small_integer(c, 4), v), along(p, 5, v)}};
    });
    add("shared_point", [](DrawStream& c) -> Question {
      const Point2d p = lattice_point(c, 50);
      return {{p, lattice_point(c, 50)}, {lattice_point(c, 50), p}};
    });
    add("axis_parallel", [](DrawStream& c) -> Question {
      const Point2d p = lattice_point(c, 50), q = lattice_point(c, 50);
      const Line2d across{p, {p.x + one_to(c, 8), p.y}};
      return c.coin() ? Question{across, {q, {q.x + 1, q.y}}} : Question{across, {q, {q.x, q.y + 1}}};
    });
    add("zero_length", [](DrawStream& c) -> Question {
      const Point2d p = lattice_point(c);
      return {{p, p}, {p, along(p, 1, lattice_direction(c))}};
    });
    add("nearly_parallel", [](DrawStream& c) -> Question {
      const Point2d p{ordinary(c), ordinary(c)}, q{ordinary(c), ordinary(c)};
      const Vector2d v{ordinary(c), ordinary(c)};
      return {{p, along(p, 1, v)}, {q, along(q, ordinary(c), v)}};
    });
    add("past_half_the_bound", [](DrawStream& c) -> Question {
      // Parallel: the second line is the other side of the triple, rotated by 180 degrees.
      const auto [p0, p1, p] = rounded_triple(c, true);
      return {{p0, p1}, {{-p.x, -p.y}, {-p0.x, -p0.y}}};
    });
  }

  /// Two times the diagonal, by points whose differences have to be rounded; moves the first point of a.
  static Question map_centre() { return {{{0.5, 0.5}, {12, 12}}, {{17, 17}, {24, 24}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<line_line> hooks() {
    return {.map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::affine, .scales = true, .exchanges = {{0, 1, {{"ta", "tb"}}}}}};
  }
};

}  // namespace touchstone::catalogue::rows
