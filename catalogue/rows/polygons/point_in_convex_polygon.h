// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "catalogue/families/list_draws.h"
#include "catalogue/families/rings.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/polygons/point_in_convex_polygon.h"
#include "oracle/lines/orientation.h"
#include "oracle/polygons/point_in_convex_polygon.h"
#include "reference/polygons/point_in_convex_polygon.h"
#include "robust/batch/point_in_convex_polygon.h"
#include "robust/polygons/point_in_convex_polygon.h"
#include "robust/prepared/polygon.h"

namespace touchstone::catalogue::rows {

struct point_in_convex_polygon : signatures::point_in_convex_polygon {
  TOUCHSTONE_STAGED_MODULES(point_in_convex_polygon)
  TOUCHSTONE_PREPARED(point_in_convex_polygon, ConvexPolygon)
  TOUCHSTONE_ARRAYS(point_in_convex_polygon)

  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "polygons",
      .pages = "16-17",
      .question = "Does the point lie inside the convex polygon, on an edge, or outside?",
      .kind = Kind::decision,
      .fields = {"polygon", "point"},
      .answer = "location",
      .margin_degree = 2,
      .time = grows(Growth::linearithmic),
      .list_length = 4};

  static void hard_cases(HardCases<Question>& add) {
    add("on_edge", turned_with_point<convex_ring, on_an_edge>);
    add("beside_edge", turned_with_point<convex_ring, near_edge>);
    add("on_line_of_edge", turned_with_point<convex_ring, on_line_of_an_edge>);
    add("beside_least_edge", beside_least_edge);
    add("on_diagonal", [](DrawStream& c) -> Question {
      const Polygon2d ring = turned(convex_ring(c), c);
      const Point2d a = ring[c.below(ring.size())], b = ring[c.below(ring.size())];
      return {ring, along(a, small_integer(c) / 8, b - a)};
    });
    add("flat_vertices", [](DrawStream& c) -> Question {
      Polygon2d ring = convex_ring(c);
      for (Point2d& p : ring.vertices) p = {4 * p.x, 4 * p.y};
      for (std::uint64_t more = 1 + c.below(2); more > 0; --more) ring = with_flat_vertex(ring, c);
      ring = turned(ring, c);
      return {ring, c.coin() ? on_an_edge(ring, c) : nudged(any_vertex(ring, c), c)};
    });
    add("needle", needle_and_point);
    add("not_quite_convex", [](DrawStream& c) -> Question {
      Polygon2d ring = turned(convex_ring(c), c);
      switch (c.below(5)) {
        case 0: break;
        case 1: ring = with_repeated_vertex(ring, c); break;
        case 2: ring = with_spike(ring, c); break;
        case 3: std::swap(ring.vertices[0], ring.vertices[c.below(ring.size())]); break;
        default: ring.vertices[0] = nudged(on_an_edge({{ring.previous(0), ring[1], ring[1]}}, c), c);
      }
      return {ring, nudged(ring[0], c)};
    });
    add("near_a_million", [](DrawStream& c) -> Question {
      Polygon2d ring = convex_ring(c);
      for (Point2d& p : ring.vertices) p = {1e6 + p.x / 10, 1e6 + p.y / 10};
      return {turned(ring, c), on_an_edge(ring, c)};
    });
    add("rounded_on_edge", [](DrawStream& c) -> Question {
      Question question;
      Polygon2d& ring = std::get<0>(question);
      for (std::uint64_t more = 3 + c.below(6); more > 0; --more) ring.vertices.push_back({ordinary(c), ordinary(c)});
      repair(question);
      const std::size_t i = c.below(ring.size());
      std::get<1>(question) = along(ring[i], static_cast<double>(c.below(1 << 20)) * 0x1p-20, ring.next(i) - ring[i]);
      return question;
    });
    add("closed_ring", [](DrawStream& c) -> Question {
      const Polygon2d ring = closed(turned(convex_ring(c), c), c);
      return {ring, c.coin() ? on_an_edge(ring, c) : nudged(any_vertex(ring, c), c)};
    });
    add.unscaled("many_edges", [](DrawStream& c) -> Question {
      const Polygon2d ring = turned(long_convex_ring(c), c);
      const std::size_t i = late_index(ring.size(), c);
      const Point2d p = ring[i] + up_to(c, 8) / 8 * (ring.next(i) - ring[i]);
      return {ring, nudged(p, c)};
    });
  }

  /// The convex hull of the vertices, every second time clockwise. Points without a hull stay and are refused.
  static void repair(Question& question) {
    std::vector<Point2d>& vertices = std::get<0>(question).vertices;
    if (vertices.size() < 3) return;
    const bool clockwise = vertices.size() % 2 == 0;
    std::vector<Point2d> sorted = vertices, hull;
    std::sort(sorted.begin(), sorted.end(),
              [](const Point2d& p, const Point2d& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
    for (int half = 0; half < 2; ++half) {
      const std::size_t start = hull.size();
      for (const Point2d& p : sorted) {
        while (hull.size() >= start + 2 &&
               ::touchstone::oracle::orientation_side(hull[hull.size() - 2], hull.back(), p) != Side::left)
          hull.pop_back();
        hull.push_back(p);
      }
      hull.pop_back();  // the other half begins with it
      std::reverse(sorted.begin(), sorted.end());
    }
    if (hull.size() < 3) return;
    if (clockwise) std::reverse(hull.begin(), hull.end());
    vertices = hull;
  }

  /// The point (12, 12), on the edge from (24, 24) to (0.5, 0.5), is moved.
  static Question map_centre() { return {{{{0.5, 0.5}, {24, 4}, {24, 24}}}, {12, 12}}; }

  static Hooks<point_in_convex_polygon> hooks() {
    return {.as_open_sets = outside_if_on_boundary<Question>,
            .repair = repair,
            .map_centre = map_centre,
            .laws = {.maps = Laws::Maps::affine, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
