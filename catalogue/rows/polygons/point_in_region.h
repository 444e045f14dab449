// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/figures.h"
#include "catalogue/families/plane_draws.h"
#include "catalogue/families/regions/region_draws.h"
#include "catalogue/families/rings.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/polygons/point_in_region.h"
#include "oracle/polygons/point_in_region.h"
#include "reference/polygons/point_in_region.h"
#include "robust/polygons/point_in_region.h"
#include "robust/prepared/polygon.h"

namespace touchstone::catalogue::rows {

struct point_in_region : signatures::point_in_region {
  TOUCHSTONE_STAGED_MODULES(point_in_region)
  TOUCHSTONE_PREPARED(point_in_region, Region)

  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "polygons",
      .pages = "14-15",
      .question = "Does the point lie inside the polygon with holes, on an edge of one of its rings, or outside?",
      .kind = Kind::decision,
      .fields = {"region", "point"},
      .answer = "location",
      .margin_degree = 2,
      .cost = 5,
      .time = {.robust = Growth::quadratic,
               .oracle = Growth::quadratic,
               .ask = Growth::quadratic,
               .reference = Growth::linear},
      .list_length = 3};

  static void hard_cases(HardCases<Question>& add) {
    add("on_edge", [](DrawStream& c) -> Question {
      const Region2d made = region_with_hole(c);
      return {turned_region(made, c), on_an_edge_of(made, c)};
    });
    add("beside_edge", [](DrawStream& c) -> Question {
      const Region2d made = region_with_hole(c);
      return {turned_region(made, c), nudged(on_an_edge_of(made, c), c)};
    });
    add("level_with_vertex", [](DrawStream& c) -> Question {
      const Region2d made = region_with_hole(c);
      const Polygon2d& one = any_ring(made, c);
      const double y = any_vertex(one, c).y;
      const Polygon2d& other = any_ring(made, c);
      return {made, {any_vertex(other, c).x, y}};
    });
    add("between_vertices", [](DrawStream& c) -> Question {
      // Two vertices of one ring; in a hole, mostly.
      const Region2d made = region_with_hole(c);
      const Polygon2d& ring = any_ring(made, c);
      const Point2d p = any_vertex(ring, c), q = any_vertex(ring, c);
      return {turned_region(made, c), {(p.x + q.x) / 2, (p.y + q.y) / 2}};
    });
    add("on_vertex", [](DrawStream& c) -> Question {
      const Region2d made = region_with_hole(c);
      const Polygon2d& ring = any_ring(made, c);
      return {turned_region(made, c), any_vertex(ring, c)};
    });
    add("no_holes", [](DrawStream& c) -> Question {
      const Polygon2d ring = turned(simple_ring(c), c);
      return {{ring, {}}, nudged(on_an_edge(ring, c), c)};
    });
    add("fitting_or_not", [](DrawStream& c) -> Question {
      const Region2d made = fitting_or_not(c);
      return {made, {up_to(c, 9), up_to(c, 9)}};
    });
    add("nested_holes", [](DrawStream& c) -> Question {
      // One around the other, or touching it from within.
      const double at = 2 + up_to(c, 3), size = one_to(c, 2);
      const Polygon2d around{{{2, 2}, {8, 2}, {8, 8}, {2, 8}}};
      const Polygon2d within{{{at, 4}, {at + size, 3}, {at + size, 5}}};
      const Polygon2d outer{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}};
      const Point2d point{up_to(c, 9), up_to(c, 9)};
      if (c.coin()) return {{outer, {within, around}}, point};
      return {{outer, {around, within}}, point};
    });
    add("defective_ring", [](DrawStream& c) -> Question {
      const Region2d made = with_defective_ring(c);
      return {made, on_an_edge_of(made, c)};
    });
    add("computed", [](DrawStream& c) -> Question {
      const Region2d made = computed_region(c);
      return {made, on_an_edge_of(made, c)};
    });
    add("beside_least_edge", [](DrawStream& c) -> Question {
      const auto [ring, point] = beside_least_edge(c);
      return {{{{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}}, {ring}}, point};
    });
    add("needle", [](DrawStream& c) -> Question {
      const auto [ring, point] = needle_and_point(c);
      const double far = 0x1p45;
      return {{{{{-far, -far}, {far, -far}, {far, far}, {-far, far}}}, {ring}}, point};
    });
    add.unscaled("many_holes", [](DrawStream& c) -> Question {
      const Region2d made = lattice_of_holes(c);
      return {made, {up_to(c, 16), up_to(c, 32) / 2}};
    });
  }

  static void repair(Question& question) { untangle(std::get<0>(question)); }

  /// Two vertices of a hole and the point run over a grid; another hole touches a corner.
  static std::uint64_t domain_count(int size) { return configurations_of_digits(size, 6); }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    const double x = digit(), y = digit(), z = digit(), w = digit(), u = digit(), v = digit();
    const Polygon2d outer{{{0, 0}, {6, 0}, {6, 6}, {0, 6}}}, corner{{{0, 6}, {2, 4}, {1, 3}}};
    return {{outer, {corner, {{{2, 2}, {2 * x, 2 * y}, {2 * z, 2 * w}}}}}, {2 * u, 2 * v}};
  }

  /// On the edge of a hole.
  static Question map_centre() {
    return {{{{{-12, -12}, {24, -12}, {24, 24}, {-12, 24}}}, {{{{0, 0}, {12, 3}, {6, 12}}}}}, {8, 2}};
  }

  static Hooks<point_in_region> hooks() {
    return {.as_open_sets = outside_if_on_boundary<Question>,
            .repair = repair,
            .map_centre = map_centre,
            .domain_count = domain_count,
            .domain_at = domain_at,
            .laws = {.maps = Laws::Maps::affine, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
