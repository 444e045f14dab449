// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/figures.h"
#include "catalogue/families/rings.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/polygons/polygon_polygon.h"
#include "oracle/polygons/polygon_polygon.h"
#include "reference/polygons/polygon_polygon.h"
#include "robust/polygons/polygon_polygon.h"
#include "robust/prepared/polygon.h"

namespace touchstone::catalogue::rows {

struct polygon_polygon : signatures::polygon_polygon {
  TOUCHSTONE_STAGED_MODULES(polygon_polygon)
  TOUCHSTONE_PREPARED(polygon_polygon, SimplePolygon)

  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "polygons",
      .pages = "18-19",
      .question = "Do the two simple polygons, as closed solids, overlap, only touch, or neither?",
      .kind = Kind::decision,
      .fields = {"a", "b"},
      .answer = "contact",
      .margin_degree = 2,
      .cost = 5,
      .time = {.robust = Growth::quadratic,
               .oracle = Growth::linearithmic,
               .ask = Growth::quadratic,
               .reference = Growth::quadratic},
      .list_length = 3};

  static void hard_cases(HardCases<Question>& add) {
    add("coincident", [](DrawStream& c) -> Question {
      const Polygon2d ring = simple_ring(c);
      return {ring, turned(ring, c)};
    });
    add("shared_vertex", [](DrawStream& c) -> Question {
      const Polygon2d a = simple_ring(c), b = simple_ring(c);
      return {a, with_vertex_at(b, a[c.below(a.size())], c)};
    });
    add("vertex_on_edge", [](DrawStream& c) -> Question {
      const Polygon2d a = simple_ring(c), flat = with_flat_vertex(a, c), b = simple_ring(c);
      return {a, with_vertex_at(b, flat[c.below(flat.size())], c)};
    });
    add("corner_in_corner", [](DrawStream& c) -> Question {
      // Only one of the corners that meet begins in the other; or they meet in the last vertex of both.
      const bool last = c.coin();
      const Polygon2d a = last ? Polygon2d{{{0, 0}, {3, 1}, {0, 3}}} : Polygon2d{{{1, 1}, {1, 2}, {4, 2}}},
                      b = last ? Polygon2d{{{1, 1}, {3, 1}, {1, 1.5}}} : Polygon2d{{{1, 4}, {2, 2}, {0, 0}}};
      return c.coin() ? Question{b, turned(a, c)} : Question{a, turned(b, c)};
    });
    add("common_edge", [](DrawStream& c) -> Question {
      const Polygon2d a = simple_ring(c);
      const std::size_t i = c.below(a.size());
      const Vector2d along = a.next(i) - a[i], out{along.y, -along.x};
      const double k = small_integer(c, 2), depth = 1 + small_integer(c, 3);
      const Point2d p = a[i] + k * along, q = p + one_to(c, 2) * along;
      return {a, turned({{p, p + depth * out, q + depth * out, q}}, c)};
    });
    add("inscribed", [](DrawStream& c) -> Question {
      const Polygon2d outer = turned(convex_ring(c), c);
      Polygon2d inner;
      for (std::size_t i = 0; i < outer.size(); ++i) inner.vertices.push_back(with_flat_middle(outer, i));
      return c.coin() ? Question{turned(inner, c), outer} : Question{outer, turned(inner, c)};
    });
    add("nested_sharing_a_vertex", [](DrawStream& c) -> Question {
      const Polygon2d outer = convex_ring(c);
      const std::size_t i = c.below(outer.size());
      Polygon2d inner = outer;
      for (Point2d& p : inner.vertices) p = {(p.x + outer[i].x) / 2, (p.y + outer[i].y) / 2};
      return {outer, turned(inner, c)};
    });
    add("nested", [](DrawStream& c) -> Question {
      const Polygon2d star = star_ring(c);
      Polygon2d around = star;
      const Point2d a = star[0], b = star[star.size() / 2], centre{(a.x + b.x) / 2, (a.y + b.y) / 2};
      for (Point2d& p : around.vertices) p = centre + 4.0 * (p - centre);
      return {turned(around, c), star};
    });
    add("in_a_bay", [](DrawStream& c) -> Question {
      const double depth = 2 + up_to(c, 5), width = 2 + up_to(c, 5);
      const Polygon2d bay{
          {{-1, -1}, {width + 1, -1}, {width + 1, depth}, {width, depth}, {width, 0}, {0, 0}, {0, depth}, {-1, depth}}};
      const double x = up_to(c, 3), y = up_to(c, 3), s = one_to(c, 4);
      return {turned(bay, c), turned({{{x, y}, {x + s, y}, {x + s, y + 2 * s}, {x, y + 2 * s}}}, c)};
    });
    add("apart", [](DrawStream& c) -> Question { return {turned(simple_ring(c), c), simple_ring(c)}; });
    add("spike", [](DrawStream& c) -> Question {
      const Polygon2d a = simple_ring(c);
      return in_either_order(c, a, with_spike(a, c));
    });
    add("repeated_vertex", [](DrawStream& c) -> Question {
      const Polygon2d a = simple_ring(c);
      return in_either_order(c, a, with_repeated_vertex(a, c));
    });
    add("rounded_vertex_on_edge", [](DrawStream& c) -> Question {
      const Polygon2d a{{{ordinary(c), ordinary(c)}, {ordinary(c), ordinary(c)}, {ordinary(c), ordinary(c)}}};
      return {a, {{along(a[0], ordinary(c), a[1] - a[0]), {ordinary(c), ordinary(c)}, {ordinary(c), ordinary(c)}}}};
    });
    add("computed", [](DrawStream& c) -> Question {
      // A vertex of b on an edge of a, but for rounding.
      Polygon2d a = with_flat_runs(simple_ring(c), c);
      const Point2d p = on_an_edge(a, c);
      const Vector2d v = lattice_direction(c), w = lattice_direction(c);
      a.vertices.insert(a.vertices.end(), {p, p + v, p + w});
      compute(a.vertices, c);
      const Polygon2d b{{a.vertices.end() - 3, a.vertices.end()}};
      a.vertices.resize(a.size() - 3);
      return {a, b};
    });
    add("closed_ring", [](DrawStream& c) -> Question {
      const std::uint64_t which = c.below(3);
      const Polygon2d a = simple_ring(c), other = simple_ring(c);
      const Point2d touch = on_an_edge(a, c);
      const Polygon2d b = with_vertex_at(other, touch, c);
      return {which == 0 ? a : closed(a, c), which == 1 ? b : closed(b, c)};
    });
  }

  static void repair(Question& question) { untangle(std::get<0>(question)), untangle(std::get<1>(question)); }

  /// A vertex of b on an edge of a.
  static Question map_centre() { return {{{{-12, -12}, {24, 24}, {-12, 30}}}, {{{0.5, 0.5}, {20, -5}, {16, -9}}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {8, 9}; }

  static Hooks<polygon_polygon> hooks() {
    return {.as_open_sets = disjoint_if_touching<Question>,
            .repair = repair,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::affine, .scales = true, .exchanges = {{0, 1}}}};
  }

 private:
  /// The ring moved so that one of its vertices is p.
  static Polygon2d with_vertex_at(Polygon2d ring, const Point2d& p, DrawStream& c) {
    const Vector2d by = p - ring[c.below(ring.size())];
    for (Point2d& vertex : ring.vertices) vertex = vertex + by;
    return ring;
  }
  static Point2d with_flat_middle(const Polygon2d& ring, std::size_t i) {
    return {(ring[i].x + ring.next(i).x) / 2, (ring[i].y + ring.next(i).y) / 2};
  }
};

}  // namespace touchstone::catalogue::rows
