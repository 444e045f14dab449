// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/rings.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/polygons/interior_angles.h"
#include "oracle/polygons/interior_angles.h"
#include "reference/polygons/interior_angles.h"
#include "robust/polygons/interior_angles.h"

namespace touchstone::catalogue::rows {

struct interior_angles : signatures::interior_angles {
  TOUCHSTONE_MODULES(interior_angles)

  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "polygons",
      .pages = "6",
      .question = "Which angle, in radians, has the inside of the simple polygon at each vertex?",
      .kind = Kind::measure,
      .fields = {"polygon"},
      .answer = "angles",
      .ulps = 18,
      .cost = 9,
      .time = {.robust = Growth::linearithmic,
               .oracle = Growth::linearithmic,
               .ask = Growth::linearithmic,
               .reference = Growth::linear},
      .list_length = 4};

  static void hard_cases(HardCases<Question>& add) {
    add("simple", [](DrawStream& c) -> Question { return turned(simple_ring(c), c); });
    add("flat_vertex", [](DrawStream& c) -> Question {
      Polygon2d ring = simple_ring(c);
      for (Point2d& p : ring.vertices) p = {2 * p.x, 2 * p.y};
      return turned(with_flat_vertex(ring, c), c);
    });
    add("right_angles", [](DrawStream& c) -> Question {
      const Point2d p = lattice_point(c);
      const Vector2d v = lattice_direction(c), w{-v.y, v.x};
      const double a = one_to(c, 8), b = one_to(c, 8);
      const Point2d q = along(along(p, a, v), b, w);
      return turned(
          {{p, along(p, a + 1, v), along(along(p, a + 1, v), b, w), q, along(q, 1, w), along(along(p, b, w), 1, w)}},
          c);
    });
    add("needle", [](DrawStream& c) -> Question {
      // Two long edges one unit apart at one end: an angle of about 2^-k there, and where it is a dent, 2 pi less
      // that.
      const double length = power_of_two(c, 1, 40), rise = small_integer(c);
      const Point2d tip{length, length * rise};
      if (!c.coin()) return turned({{{0, 0}, tip, {0, 1}, {-length, rise}}}, c);
      return turned(
          {{{0, 0}, tip, {0, 1}, {-1, 1}, {-1, 3 * length * 9}, {3 * length, 0}, {-1, -3 * length * 9}, {-1, 0}}}, c);
    });
    add("least_angle", [](DrawStream& c) -> Question {
      // About the least subnormal number, or half of it.
      const double x = 1 + up_to(c, 15) / 8;
      return turned({{{0, 0}, {x, 0}, {x, std::ldexp(one_to(c, 3), -1074)}}}, c);
    });
    add("nearly_flat", [](DrawStream& c) -> Question { return nearly_flat_ring(c); });
    add("thin_beyond_doubles", [](DrawStream& c) -> Question {
      // Angles of about 2^-(j + k): from those that are doubles to those that round to 0.
      const double wide = scaled_up(c, 8, 1000);
      return turned({{{0, 0}, {wide, 0}, {wide, scaled_down(c, 8, 1050)}}}, c);
    });
    add("perhaps_not_simple", [](DrawStream& c) -> Question {
      const Polygon2d ring = simple_ring(c);
      const std::uint64_t defect = c.below(3);
      return turned(defect == 0 ? ring : defect == 1 ? with_spike(ring, c) : with_repeated_vertex(ring, c), c);
    });
    add("typed_flat", [](DrawStream& c) -> Question { return typed_flat_ring(c); });
    add("far_from_origin", [](DrawStream& c) -> Question {
      Polygon2d ring = simple_ring(c);
      for (Point2d& p : ring.vertices) p = {1e6 + 0.1 * p.x, 1e6 + 0.1 * p.y};
      return turned(ring, c);
    });
    add("flat_runs", [](DrawStream& c) -> Question { return turned(with_flat_runs(simple_ring(c), c), c); });
    add("closed_ring", [](DrawStream& c) -> Question { return closed(turned(simple_ring(c), c), c); });
  }

  /// A vertex on the line of its neighbours; one of them moves.
  static Question map_centre() { return {{{{12, 12}, {24, 24}, {0, 30}, {0.5, 0.5}}}}; }

  static void repair(Question& question) { untangle(std::get<0>(question)); }

  static Hooks<interior_angles> hooks() { return {.repair = repair, .map_centre = map_centre}; }
};

}  // namespace touchstone::catalogue::rows
