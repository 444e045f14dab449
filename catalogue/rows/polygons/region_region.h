// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "catalogue/draw/figures.h"
#include "catalogue/families/plane_draws.h"
#include "catalogue/families/regions/region_draws.h"
#include "catalogue/families/rings.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/polygons/region_region.h"
#include "oracle/polygons/region_region.h"
#include "reference/polygons/region_region.h"
#include "robust/polygons/region_region.h"
#include "robust/prepared/polygon.h"

namespace touchstone::catalogue::rows {

struct region_region : signatures::region_region {
  TOUCHSTONE_STAGED_MODULES(region_region)
  TOUCHSTONE_PREPARED(region_region, Region)

  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "polygons",
      .pages = "18-19",
      .question = "Do the two polygons with holes, as closed solids, overlap, only touch, or neither?",
      .kind = Kind::decision,
      .fields = {"a", "b"},
      .answer = "contact",
      .margin_degree = 2,
      .cost = 10,
      .time = {.robust = Growth::quadratic,
               .oracle = Growth::quadratic,
               .ask = Growth::quadratic,
               .reference = Growth::quadratic},
      .list_length = 3};

  static void hard_cases(HardCases<Question>& add) {
    add("coincident", [](DrawStream& c) -> Question {
      const Region2d a = region(c);
      return {a, turned_region(a, c)};
    });
    add("fills_hole", [](DrawStream& c) -> Question {
      // Exactly, or moved a little.
      const Region2d a = region_with_hole(c);
      const Polygon2d hole = turned(a.holes[c.below(a.holes.size())], c);
      const double x = small_integer(c, 1), y = small_integer(c, 1);
      return in_either_order(c, a, Region2d{moved(hole, {x, y}), {}});
    });
    add("in_hole", [](DrawStream& c) -> Question {
      // As large as the hole seen from one of its vertices, or smaller, or larger.
      const Region2d a = region_with_hole(c);
      const Polygon2d& hole = a.holes[c.below(a.holes.size())];
      const Point2d p = any_vertex(hole, c);
      const double size = one_to(c, 5) / 4;
      Polygon2d island = hole;
      for (Point2d& q : island.vertices) q = along(p, size, q - p);
      return in_either_order(c, a, Region2d{turned(island, c), {}});
    });
    add("fills_one_of_many", [](DrawStream& c) -> Question {
      // One hole among many, some of which touch it.
      const Region2d a = lattice_of_holes(c);
      const Region2d b{a.holes[c.below(a.holes.size())], {}};
      return {a, b};
    });
    add("outer_alone", [](DrawStream& c) -> Question {
      const Region2d a = region(c);
      return in_either_order(c, a, Region2d{turned(a.outer, c), {}});
    });
    add("in_corner_of_hole", [](DrawStream& c) -> Question {
      // Two triangles in one corner of the outer ring: a hole of a, and b, which is within the hole or not.
      const double s = up_to(c, 4), t = up_to(c, 4);
      const Region2d a{{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}}, {{{{0, 0}, {8, 2}, {2, 7}}}}};
      return in_either_order(c, a, Region2d{turned({{{0, 0}, {1 + s, 4 - s}, {t, 3.5}}}, c), {}});
    });
    add("inscribed", [](DrawStream& c) -> Question {
      // Vertices of one on edges of the other, which begin outside of the angles there.
      const double at = one_to(c, 7);
      const Polygon2d square{{{0, 0}, {8, 0}, {8, 8}, {0, 8}}};
      const Polygon2d inner = turned({{{at, 0}, {8, at}, {8 - at, 8}, {0, 8 - at}}}, c);
      return in_either_order(c, Region2d{inner, {}}, Region2d{square, {{{{3, 3}, {5, 4}, {4, 5}}}}});
    });
    add("corner_in_corner", [](DrawStream& c) -> Question {
      // Only one of the corners that meet begins in the other.
      const Polygon2d a{{{1, 1}, {1, 2}, {4, 2}}}, b{{{1, 4}, {2, 2}, {0, 0}}};
      if (c.coin()) return {{b, {}}, {turned(a, c), {}}};
      return {{a, {}}, {turned(b, c), {}}};
    });
    add("holes_at_crossings", [](DrawStream& c) -> Question {
      const auto [a, b] = holes_at_crossings(c);
      return {a, b};
    });
    add("shared_vertex", [](DrawStream& c) -> Question {
      const Region2d a = region_with_hole(c), b = region(c);
      const Polygon2d& ring = any_ring(a, c);
      const Point2d p = any_vertex(ring, c);
      return {a, with_vertex_at(b, p, c)};
    });
    add("vertex_on_edge", [](DrawStream& c) -> Question {
      const Region2d a = region_with_hole(c), b = region(c);
      return {a, with_vertex_at(b, on_an_edge_of(a, c), c)};
    });
    add("beside_each_other", [](DrawStream& c) -> Question {
      const Region2d a = region(c), b = region(c);
      return {turned_region(a, c), b};
    });
    add("around", [](DrawStream& c) -> Question {
      // The hole of a large square, around another region or not quite.
      const Region2d a = region(c);
      const double far = 0x1p34, size = std::ldexp(1.0, static_cast<int>(20 + c.below(14)));
      const auto square = [](double s) { return Polygon2d{{{-s, -s}, {s, -s}, {s, s}, {-s, s}}}; };
      return in_either_order(c, a, Region2d{square(far), {turned(square(size), c)}});
    });
    add("fitting_or_not", [](DrawStream& c) -> Question {
      const Region2d a = fitting_or_not(c), b = fitting_or_not(c);
      return {a, with_vertex_at(b, {up_to(c, 8), up_to(c, 8)}, c)};
    });
    add("defective_ring", [](DrawStream& c) -> Question {
      const Region2d a = with_defective_ring(c);
      return in_either_order(c, a, region(c));
    });
    add("computed", [](DrawStream& c) -> Question {
      const Region2d a = computed_region(c);
      return {a, {turned(a.holes[c.below(a.holes.size())], c), {}}};
    });
    add.unscaled("many_holes", [](DrawStream& c) -> Question {
      const Region2d a = lattice_of_holes(c), b = lattice_of_holes(c);
      return {a, with_vertex_at(b, {up_to(c, 20), up_to(c, 20)}, c)};
    });
  }

  static void repair(Question& question) { untangle(std::get<0>(question)), untangle(std::get<1>(question)); }

  /// Two vertices of a's hole, and b, a triangle with a hole in its corner, run over a grid.
  static std::uint64_t domain_count(int size) { return configurations_of_digits(size, 6); }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    const double x = digit(), y = digit(), z = digit(), w = digit(), u = 4 * digit(), v = 4 * digit();
    const Polygon2d outer{{{0, 0}, {12, 0}, {12, 12}, {0, 12}}};
    return {{outer, {{{{4, 4}, {4 * x, 4 * y}, {4 * z, 4 * w}}}}},
            {{{{u, v}, {u + 4, v}, {u, v + 4}}}, {{{{u, v}, {u + 2, v + 1}, {u + 1, v + 2}}}}}};
  }

  /// A vertex of b on an edge of a's hole.
  static Question map_centre() {
    return {{{{{-24, -24}, {24, -24}, {24, 24}, {-24, 24}}}, {{{{-12, -12}, {12, -12}, {12, 12}, {-12, 12}}}}},
            {{{{12, 0}, {3, 5}, {-4, -6}}}, {}}};
  }

  static Hooks<region_region> hooks() {
    return {.as_open_sets = disjoint_if_touching<Question>,
            .repair = repair,
            .map_centre = map_centre,
            .domain_count = domain_count,
            .domain_at = domain_at,
            .laws = {.maps = Laws::Maps::affine, .scales = true, .exchanges = {{0, 1}}}};
  }

 private:
  static Polygon2d moved(Polygon2d ring, const Vector2d& by) {
    for (Point2d& p : ring.vertices) p = p + by;
    return ring;
  }
  /// The region moved so that a vertex of one of its rings is p.
  static Region2d with_vertex_at(Region2d region, const Point2d& p, DrawStream& c) {
    const Polygon2d& ring = any_ring(region, c);
    const Vector2d by = p - any_vertex(ring, c);
    region.outer = moved(region.outer, by);
    for (Polygon2d& hole : region.holes) hole = moved(hole, by);
    return region;
  }
};

}  // namespace touchstone::catalogue::rows
