// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/long_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/lines/point_on_segment.h"
#include "oracle/lines/point_on_segment.h"
#include "reference/lines/point_on_segment.h"
#include "robust/batch/point_on_segment.h"
#include "robust/lines/point_on_segment.h"

namespace touchstone::catalogue::rows {

struct point_on_segment : signatures::point_on_segment {
  TOUCHSTONE_STAGED_MODULES(point_on_segment)
  TOUCHSTONE_ARRAYS(point_on_segment)

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "lines",
                                     .pages = "10-11",
                                     .question = "Does the point lie on the closed segment, and at which t?",
                                     .kind = Kind::set,
                                     .fields = {"point", "segment"},
                                     .ulps = 3,
                                     .margin_degree = 2};

  struct decision {
    static Incidence robust(const Question& q) {
      return ::touchstone::robust::point_on_segment_relation(std::get<0>(q), std::get<1>(q));
    }
  };

  static void hard_cases(HardCases<Question>& add) {
    add("on_segment", [](DrawStream& c) -> Question {
      const auto [a, v] = lattice_line(c);
      const double n = one_to(c, 8), k = up_to(c, 8);
      return {along(a, k, v), {a, along(a, n, v)}};
    });
    add("at_end", [](DrawStream& c) -> Question {
      const Point2d a = lattice_point(c, 53), b = lattice_point(c, 53);
      return {c.coin() ? b : a, {a, b}};
    });
    add("collinear_beyond", [](DrawStream& c) -> Question {
      const auto [a, v] = lattice_line(c);
      return {along(a, 2 + up_to(c, 7), v), {a, along(a, 1, v)}};
    });
    add("axis_parallel", [](DrawStream& c) -> Question {
      const Point2d a = lattice_point(c, 50);
      const double length = integer(c, 50), at = c.coin() ? length : integer(c, 50);
      const bool upright = c.coin();
      return upright ? Question{{a.x, a.y + at}, {a, {a.x, a.y + length}}}
                     : Question{{a.x + at, a.y}, {a, {a.x + length, a.y}}};
    });
    add("zero_length", [](DrawStream& c) -> Question {
      const Point2d a = lattice_point(c, 53);
      return {{a.x + small_integer(c, 1), a.y + small_integer(c, 1)}, {a, a}};
    });
    add("beside_segment", [](DrawStream& c) -> Question {
      const auto [a, v] = lattice_line(c);
      const Point2d p = along(a, up_to(c, 3), v);
      return {{p.x + small_integer(c, 1), p.y}, {a, along(a, 4, v)}};
    });
    add("on_long_segment", [](DrawStream& c) -> Question {
      const auto [a, v] = lattice_line(c, 45, 45);
      const double n = one_to(c, 8), k = up_to(c, 8);
      return {along(a, k, v), {a, along(a, n, v)}};
    });
    add("rounded_on_segment", [](DrawStream& c) -> Question {
      const Segment2d s{{ordinary(c), ordinary(c)}, {ordinary(c), ordinary(c)}};
      return {along(s.a, ordinary(c), s.b - s.a), s};
    });
    add("typed_on_segment", [](DrawStream& c) -> Question {
      const double x = typed(c), y = typed(c), k = up_to(c, 3);
      return {{x, y}, {{0.0, 0.0}, {k * x, k * y}}};
    });
    add("on_long_line", [](DrawStream& c) -> Question {
      const auto [first, last, between] = long_triple(c);
      return {between, {first, last}};
    });
  }

  static std::optional<PointOnSegment<mpq_class>> as_open_sets(const PointOnSegment<mpq_class>& truth,
                                                               const Question&) {
    if (!truth.t || (*truth.t != 0 && *truth.t != 1)) return std::nullopt;
    return PointOnSegment<mpq_class>{Incidence::off, std::nullopt};
  }

  /// The point (12, 12) of the segment (0.5, 0.5) - (24, 24); moves the end near the origin.
  static Question map_centre() { return {{12, 12}, {{0.5, 0.5}, {24, 24}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {2, 3}; }

  static Hooks<point_on_segment> hooks() {
    return {.as_open_sets = as_open_sets,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::affine, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
