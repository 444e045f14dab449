// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/long_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/shape/walk.h"
#include "catalogue/signatures/lines/segment_segment.h"
#include "oracle/exact/systems/elimination.h"
#include "oracle/lines/segment_segment.h"
#include "reference/lines/segment_segment.h"
#include "robust/batch/segment_segment.h"
#include "robust/lines/segment_segment.h"

namespace touchstone::catalogue::rows {

struct segment_segment : signatures::segment_segment {
  TOUCHSTONE_STAGED_MODULES(segment_segment)
  TOUCHSTONE_ARRAYS(segment_segment)

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "lines",
                                     .pages = "12-13",
                                     .question = "What do the two closed segments have in common?",
                                     .kind = Kind::set,
                                     .fields = {"a", "b"},
                                     .ulps = 15,
                                     .margin_degree = 2};

  static void hard_cases(HardCases<Question>& add) {
    add("crossing_on_lattice", [](DrawStream& c) -> Question {
      const Point2d p = lattice_point(c);
      const Vector2d u = lattice_direction(c), v = lattice_direction(c);
      return {{along(p, -one_to(c, 4), u), along(p, 1, u)}, {along(p, -one_to(c, 4), v), along(p, 1, v)}};
    });
    add("shared_end", [](DrawStream& c) -> Question {
      const Point2d p = lattice_point(c, 50);
      const Segment2d a{p, lattice_point(c, 50)}, b{lattice_point(c, 50), p};
      return c.coin() ? Question{a, {b.b, b.a}} : Question{a, b};
    });
    add("end_on_segment", [](DrawStream& c) -> Question {
      const auto [p, v] = lattice_line(c);
      return {{p, along(p, one_to(c, 8), v)}, {along(p, up_to(c, 8), v), lattice_point(c)}};
    });
    add("collinear", [](DrawStream& c) -> Question {
      const auto [p, v] = lattice_line(c);
      return {{p, along(p, small_integer(c), v)}, {along(p, small_integer(c), v), along(p, small_integer(c), v)}};
    });
    add("collinear_end_to_end", [](DrawStream& c) -> Question {
      const auto [p, v] = lattice_line(c);
      const double k = one_to(c, 4);
      return {{p, along(p, k, v)}, {along(p, k, v), along(p, k + small_integer(c, 4), v)}};
    });
    add("coincident", [](DrawStream& c) -> Question {
      const Segment2d a{lattice_point(c, 50), lattice_point(c, 50)};
      return {a, c.coin() ? Segment2d{a.b, a.a} : a};
    });
    add("parallel", [](DrawStream& c) -> Question {
      const Point2d p = lattice_point(c), q = lattice_point(c);
      const Vector2d v = lattice_direction(c);
      return {{p, along(p, one_to(c, 4), v)}, {q, along(q, small_integer(c, 4), v)}};
    });
    add("axis_parallel", [](DrawStream& c) -> Question {
      const Point2d p = lattice_point(c, 50), q = lattice_point(c, 50);
      const double length = integer(c, 50), other = integer(c, 50);
      const Segment2d across{p, {p.x + length, p.y}};
      return c.coin() ? Question{across, {{q.x, p.y}, {q.x + other, p.y}}} : Question{across, {q, {q.x, q.y + other}}};
    });
    add("zero_length", [](DrawStream& c) -> Question {
      const auto [p, v] = lattice_line(c);
      const Segment2d point{p, p};
      const Segment2d other{along(p, small_integer(c, 2), v), along(p, c.coin() ? 0 : small_integer(c, 2), v)};
      return c.coin() ? Question{other, point} : Question{point, other};
    });
    add("end_on_long_segment", [](DrawStream& c) -> Question {
      const auto [p, v] = lattice_line(c, 45, 45);
      return {{p, along(p, one_to(c, 8), v)}, {along(p, up_to(c, 8), v), lattice_point(c, 45)}};
    });
    add("nearly_touching", [](DrawStream& c) -> Question {
      const Segment2d a{{ordinary(c), ordinary(c)}, {ordinary(c), ordinary(c)}};
      return {a, {along(a.a, ordinary(c), a.b - a.a), {ordinary(c), ordinary(c)}}};
    });
    add("nearly_collinear", [](DrawStream& c) -> Question {
      const Segment2d a{{ordinary(c), ordinary(c)}, {ordinary(c), ordinary(c)}};
      const Vector2d v = a.b - a.a;
      return {a, {along(a.a, ordinary(c), v), along(a.a, ordinary(c), v)}};
    });
    add("end_on_long_line", [](DrawStream& c) -> Question {
      const auto [first, last, between] = long_triple(c);
      return {{first, last}, {between, along(between, 0.125, long_direction(c))}};
    });
  }

  /// Open segments do not have their ends.
  static std::optional<SegmentSegment<mpq_class>> as_open_sets(const SegmentSegment<mpq_class>& truth,
                                                               const Question&) {
    if (truth.relation != SegmentRelation::point) return std::nullopt;
    if (*truth.ta != 0 && *truth.ta != 1 && *truth.tb != 0 && *truth.tb != 1) return std::nullopt;
    return SegmentSegment<mpq_class>{SegmentRelation::disjoint, {}, {}, {}, {}};
  }

  struct decision {
    static SegmentRelation robust(const Question& q) {
      return ::touchstone::robust::segment_segment_relation(std::get<0>(q), std::get<1>(q));
    }
    static SegmentRelation oracle(const rebound_t<Question, std::int64_t>& q) {
      return ::touchstone::oracle::segment_segment_relation<std::int64_t>(std::get<0>(q), std::get<1>(q));
    }
    static SegmentRelation oracle(const Question& q) {
      return ::touchstone::oracle::segment_segment_relation(std::get<0>(q), std::get<1>(q));
    }
  };

  /// The end (12, 12) of b lies on a; moves the first end of a.
  static Question map_centre() { return {{{0.5, 0.5}, {24, 24}}, {{12, 12}, {24, 3}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<segment_segment> hooks() {
    return {
        .as_open_sets = as_open_sets,
        .map_centre = map_centre,
        .map_axes = map_axes,
        .laws = {
            .maps = Laws::Maps::affine, .scales = true, .exchanges = {{0, 1, {{"ta", "tb"}}}}, .sorted = {"overlap"}}};
  }
};

}  // namespace touchstone::catalogue::rows
