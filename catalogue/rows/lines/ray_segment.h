// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/long_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/lines/ray_segment.h"
#include "oracle/lines/ray_segment.h"
#include "reference/lines/ray_segment.h"
#include "robust/lines/ray_segment.h"

namespace touchstone::catalogue::rows {

struct ray_segment : signatures::ray_segment {
  TOUCHSTONE_STAGED_MODULES(ray_segment)

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "lines",
                                     .pages = "2, 14",
                                     .question = "Where does the ray meet the closed segment?",
                                     .kind = Kind::set,
                                     .fields = {"ray", "segment"},
                                     .ulps = 13,
                                     .margin_degree = 2};

  struct decision {
    static RayRelation robust(const Question& q) {
      return ::touchstone::robust::ray_segment_relation(std::get<0>(q), std::get<1>(q));
    }
  };

  static void hard_cases(HardCases<Question>& add) {
    add("crossing_on_lattice", [](DrawStream& c) -> Question {
      const Point2d p = lattice_point(c);
      const Vector2d u = lattice_direction(c), v = lattice_direction(c);
      return {{along(p, small_integer(c, 4), u), u}, {along(p, -one_to(c, 4), v), along(p, 1, v)}};
    });
    add("through_end", [](DrawStream& c) -> Question {
      const auto [p, v] = lattice_line(c);
      return {{p, v}, {along(p, small_integer(c, 4), v), lattice_point(c)}};
    });
    add("origin_on_segment", [](DrawStream& c) -> Question {
      const auto [p, v] = lattice_line(c);
      return {{p, lattice_direction(c)}, {along(p, -up_to(c, 3), v), along(p, up_to(c, 3), v)}};
    });
    add("collinear", [](DrawStream& c) -> Question {
      const auto [p, v] = lattice_line(c);
      return {{p, v}, {along(p, small_integer(c), v), along(p, small_integer(c), v)}};
    });
    add("ends_at_origin", [](DrawStream& c) -> Question {
      const auto [p, v] = lattice_line(c, 40);
      return {{p, v}, {along(p, -one_to(c, 4), v), p}};
    });
    add("parallel", [](DrawStream& c) -> Question {
      const Vector2d v = lattice_direction(c);
      const Point2d q = lattice_point(c);
      return {{lattice_point(c), v}, {q, along(q, small_integer(c), v)}};
    });
    add("axis_parallel", [](DrawStream& c) -> Question {
      const Point2d p = lattice_point(c, 50), q = lattice_point(c, 50);
      const Vector2d across{either_sign(c), 0.0};
      return c.coin() ? Question{{p, across}, {{q.x, p.y}, {q.x + integer(c, 50), p.y}}}
                      : Question{{p, across}, {q, {q.x, q.y + integer(c, 50)}}};
    });
    add("zero_length", [](DrawStream& c) -> Question {
      const auto [p, v] = lattice_line(c);
      const Point2d q = along(p, small_integer(c, 2), v);
      return {{p, v}, {q, q}};
    });
    add("zero_direction", [](DrawStream& c) -> Question {
      const Point2d p = lattice_point(c);
      return {{p, {0, 0}}, {p, lattice_point(c)}};
    });
    add("through_far_end", [](DrawStream& c) -> Question {
      const auto [p, v] = lattice_line(c, 45, 45);
      return {{p, v}, {along(p, small_integer(c), v), lattice_point(c, 45)}};
    });
    add("nearly_touching", [](DrawStream& c) -> Question {
      const Ray2d ray{{ordinary(c), ordinary(c)}, {ordinary(c), ordinary(c)}};
      return {ray, {along(ray.origin, ordinary(c), ray.direction), {ordinary(c), ordinary(c)}}};
    });
    add("nearly_collinear", [](DrawStream& c) -> Question {
      const Ray2d ray{{ordinary(c), ordinary(c)}, {ordinary(c), ordinary(c)}};
      return {ray, {along(ray.origin, ordinary(c), ray.direction), along(ray.origin, ordinary(c), ray.direction)}};
    });
    add("end_on_long_line", [](DrawStream& c) -> Question {
      const auto [first, last, between] = long_triple(c);
      return {{first, Vector2d{-first.x, -first.y}}, {last, along(last, 0.125, long_direction(c))}};
    });
  }

  /// An open segment does not have its ends, an open ray not its origin.
  static std::optional<RaySegment<mpq_class>> as_open_sets(const RaySegment<mpq_class>& truth,
                                                           const Question& question) {
    if (truth.relation != RayRelation::point) return std::nullopt;
    const Segment2d& segment = std::get<1>(question);
    const auto is = [&](const Point2d& end) {
      return truth.point->x == exact_value(end.x) && truth.point->y == exact_value(end.y);
    };
    if (*truth.t != 0 && !is(segment.a) && !is(segment.b)) return std::nullopt;
    return RaySegment<mpq_class>{RayRelation::none, {}, {}, {}};
  }

  /// A ray along the diagonal through the end (24, 24) of the segment; moves the origin of the ray.
  static Question map_centre() { return {{{0.5, 0.5}, {12, 12}}, {{24, 24}, {24, 3}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<ray_segment> hooks() {
    return {.as_open_sets = as_open_sets,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::affine, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
