// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/rings.h"
#include "catalogue/families/rounded_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/shape/walk.h"
#include "catalogue/signatures/polygons/point_in_polygon.h"
#include "oracle/polygons/point_in_polygon.h"
#include "reference/polygons/point_in_polygon.h"
#include "robust/batch/point_in_polygon.h"
#include "robust/polygons/point_in_polygon.h"
#include "robust/prepared/polygon.h"

namespace touchstone::catalogue::rows {

struct point_in_polygon : signatures::point_in_polygon {
  TOUCHSTONE_STAGED_MODULES(point_in_polygon)
  TOUCHSTONE_PREPARED(point_in_polygon, Polygon)
  TOUCHSTONE_ARRAYS(point_in_polygon)

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "polygons",
                                     .pages = "14-15",
                                     .question = "Does the point lie inside the polygon, on an edge, or outside?",
                                     .kind = Kind::decision,
                                     .fields = {"polygon", "point"},
                                     .answer = "location",
                                     .margin_degree = 2,
                                     .time = grows(Growth::linear),
                                     .list_length = 4};

  static void hard_cases(HardCases<Question>& add) {
    add("ray_through_vertex", [](DrawStream& c) -> Question {
      const Polygon2d ring = turned(simple_ring(c), c);
      return {ring, level_with(any_vertex(ring, c), c)};
    });
    add("ray_through_two_vertices", [](DrawStream& c) -> Question {
      Polygon2d ring = turned(simple_ring(c), c);
      const double y = any_vertex(ring, c).y;
      ring.vertices[c.below(ring.size())].y = y;
      return {ring, level_with({0, y}, c)};
    });
    add("ray_along_edge", [](DrawStream& c) -> Question {
      Polygon2d ring = turned(simple_ring(c), c);
      ring.vertices[0].y = ring[1].y;
      if (c.one_in(3)) ring.vertices[2].y = ring[1].y;
      return {ring, level_with(ring[0], c)};
    });
    add("on_edge", turned_with_point<simple_ring, on_an_edge>);
    add("on_line_of_edge", turned_with_point<simple_ring, on_line_of_an_edge>);
    add("beside_edge", turned_with_point<simple_ring, near_edge>);
    add("self_crossing", [](DrawStream& c) -> Question {
      Polygon2d ring;
      for (std::uint64_t more = 4 + c.below(9); more > 0; --more) ring.vertices.push_back(lattice_point(c));
      return {ring, lattice_point(c)};
    });
    add("at_crossing", [](DrawStream& c) -> Question {
      const Point2d p = lattice_point(c);
      const Vector2d v = lattice_direction(c), w = lattice_direction(c);
      const double s = small_integer(c), t = small_integer(c);
      return {turned({{along(p, 2, v), along(p, s, v), along(p, -1, w), along(p, t, w)}}, c), p};
    });
    add("spike", [](DrawStream& c) -> Question {
      const Polygon2d ring = with_spike(simple_ring(c), c);
      return {turned(ring, c), c.coin() ? on_an_edge(ring, c) : nudged(any_vertex(ring, c), c)};
    });
    add("more_vertices",  // than needed: repeated ones and flat ones
        [](DrawStream& c) -> Question {
          Polygon2d ring = simple_ring(c);
          for (std::uint64_t more = 1 + c.below(3); more > 0; --more) {
            ring = c.coin() ? with_flat_vertex(ring, c) : with_repeated_vertex(ring, c);
          }
          return {turned(ring, c), c.coin() ? level_with(any_vertex(ring, c), c) : nudged(any_vertex(ring, c), c)};
        });
    add("collinear_ring", [](DrawStream& c) -> Question {
      const auto [a, v] = lattice_line(c);
      const int most = c.one_in(4) ? 0 : 8;  // 0: all in one point
      Polygon2d ring;
      for (std::uint64_t more = 3 + c.below(5); more > 0; --more)
        ring.vertices.push_back(along(a, small_integer(c, most), v));
      return {ring, along(a, small_integer(c, most + 1), v)};
    });
    add("comb_or_star", [](DrawStream& c) -> Question {
      const Polygon2d ring = turned(c.coin() ? star_ring(c) : comb_ring(c), c);
      return {ring, nudged(any_vertex(ring, c), c)};
    });
    add("needle", needle_and_point);
    add("near_a_million", [](DrawStream& c) -> Question {
      Polygon2d ring = simple_ring(c);
      for (Point2d& p : ring.vertices) p = {1e6 + p.x / 10, 1e6 + p.y / 10};
      return {turned(ring, c), on_an_edge(ring, c)};
    });
    add("rounded_on_edge", [](DrawStream& c) -> Question {
      Polygon2d ring;
      for (std::uint64_t more = 3 + c.below(6); more > 0; --more) ring.vertices.push_back({ordinary(c), ordinary(c)});
      const std::size_t i = c.below(ring.size());
      return {ring, along(ring[i], static_cast<double>(c.below(1 << 20)) * 0x1p-20, ring.next(i) - ring[i])};
    });
    add("hair_beside_edge", [](DrawStream& c) -> Question {
      // The ends seen from the point need more bits than a double has, and so they turn to the wrong side as often
      // as not.
      const auto sized = [&c](std::uint64_t size) { return static_cast<double>(size + c.below(size)); };
      const Vector2d edge{sized(1 << 29), c.coin() ? sized(1 << 29) : -sized(1 << 29)};
      const Point2d origin{0, 0}, nudged = along(origin, 0x1p-30, edge);
      const double size = c.coin() ? 0x1p-11 : -0x1p-11, off = size * one_to(c, 8);
      return {turned({{along(origin, -sized(1 << 20), edge), along(origin, sized(1 << 20), edge),
                       origin + lattice_direction(c, 50)}},
                     c),
              {nudged.x, nudged.y + off}};
    });
    add("level_and_in_line", [](DrawStream& c) -> Question {
      // Level with the last of the first sixteen vertices, which robust takes together, and in line with some edge
      // of a saw.
      const std::uint64_t teeth = 2 + c.below(3), length = 5 + c.below(8);
      Polygon2d ring;
      for (std::uint64_t i = 0; i < teeth * length; ++i)
        ring.vertices.push_back({static_cast<double>(3 * i), static_cast<double>(i % length)});
      ring.vertices.push_back({static_cast<double>(3 * teeth * length), -1000});
      const Point2d level = ring[c.coin() && ring.size() > 15 ? 15 : c.below(ring.size() - 1)],
                    in_line = ring[c.below(teeth) * length];
      return {ring, {in_line.x + 3 * (level.y - in_line.y), level.y}};
    });
    add("beside_edge_from_afar", [](DrawStream& c) -> Question {
      // The sixteenth vertex, where robust's second part begins, is far from all others, and the point near the
      // end of its edge.
      Polygon2d ring = wave(18 + c.below(14), c);
      const auto far = [&c] { return static_cast<double>((1 << 29) + c.below(1 << 29)); };
      const double x = far();
      ring.vertices[15] = {c.coin() ? x : -x, far()};
      const Point2d near = ring[16], on = along(near, one_to(c, 1 << 10) * 0x1p-30, ring[15] - near);
      constexpr double nudged[] = {0, 0x1p-34, -0x1p-34};
      return {ring, {on.x, on.y + nudged[c.below(3)]}};
    });
    add("beside_least_edge", beside_least_edge);
    add("minus_zero", [](DrawStream& c) -> Question {
      // Level with the point, by either zero; the sizes keep it from every lattice.
      const double x = c.coin() ? 1 : -1, least = std::ldexp(one_to(c, 4), -1074);
      return {turned({{{0, -0.0}, {x, either_sign(c) * least}, {-x, -1e300}}}, c), {small_integer(c, 1), zero(c)}};
    });
    add("many_vertices", [](DrawStream& c) -> Question {
      const bool very_many = c.one_in(64);
      const Polygon2d ring = wave(very_many ? 1000 - c.below(800) : 16 + c.below(16), c);
      return {ring, c.one_in(3) ? on_an_edge(ring, c) : nudged(any_vertex(ring, c), c)};
    });
    add("past_half_the_bound", [](DrawStream& c) -> Question {
      const auto [point, a, b] = rounded_triple(c, c.coin());
      // The third vertex is in the filter's sums twice: (1 + size)^2 times the bound of the edge alone.
      const double size = std::ldexp(1, -3 - integer_in(c, 0, 7));
      const Point2d third = c.coin() ? Point2d{size, size} : Point2d{-size, -size};
      return {c.coin() ? Polygon2d{{a, b, third}} : Polygon2d{{b, a, third}}, point};
    });
    add("computed", [](DrawStream& c) -> Question {
      Polygon2d ring = with_flat_runs(simple_ring(c), c);
      ring.vertices.push_back(on_an_edge(ring, c));
      compute(ring.vertices, c);
      const Point2d p = ring.vertices.back();
      ring.vertices.pop_back();
      return {turned(ring, c), p};
    });
    add("closed_ring", [](DrawStream& c) -> Question {
      const Polygon2d ring = closed(turned(simple_ring(c), c), c);
      return {ring, c.coin() ? on_an_edge(ring, c) : nudged(any_vertex(ring, c), c)};
    });
  }

  struct decision {
    static Location robust(const Question& q) {
      return ::touchstone::robust::point_in_polygon(std::get<0>(q), std::get<1>(q));
    }
    static Location oracle(const rebound_t<Question, std::int64_t>& q) {
      auto around = std::get<0>(q);
      const auto& p = std::get<1>(q);
      for (auto& vertex : around.vertices) vertex = {vertex.x - p.x, vertex.y - p.y};
      return ::touchstone::oracle::location_by_winding<std::int64_t>(around);
    }
    static Location oracle(const Question& q) {
      return ::touchstone::oracle::point_in_polygon_location(std::get<0>(q), std::get<1>(q));
    }
  };

  /// The point (12, 12), on the edge from (24, 24) to (0.5, 0.5), is moved.
  static Question map_centre() { return {{{{0.5, 0.5}, {24, 4}, {24, 24}}}, {12, 12}}; }

  static Hooks<point_in_polygon> hooks() {
    return {.as_open_sets = outside_if_on_boundary<Question>,
            .map_centre = map_centre,
            .laws = {.maps = Laws::Maps::affine, .scales = true}};
  }

 private:
  /// At the same height; mostly on the left, where the ray meets what is there.
  static Point2d level_with(const Point2d& p, DrawStream& c) {
    const double size = std::fabs(integer(c, 24));
    return {c.one_in(4) ? p.x + size : p.x - size, p.y};
  }
  /// Up and down from left to right, and back in two long edges; long with few draws.
  static Polygon2d wave(std::size_t vertices, DrawStream& c) {
    const std::uint64_t step = 1 + c.below(97), height = 2 + c.below(61);
    Polygon2d ring;
    for (std::uint64_t i = 0; i + 1 < vertices; ++i) {
      ring.vertices.push_back({static_cast<double>(3 * i), static_cast<double>(step * i % height)});
    }
    ring.vertices.push_back({static_cast<double>(vertices), -1000});
    return ring;
  }
};

}  // namespace touchstone::catalogue::rows
