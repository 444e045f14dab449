// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/rings.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/polygons/polygon_convexity.h"
#include "oracle/polygons/polygon_convexity.h"
#include "reference/polygons/polygon_convexity.h"
#include "robust/polygons/polygon_convexity.h"

namespace touchstone::catalogue::rows {

struct polygon_convexity : signatures::polygon_convexity {
  TOUCHSTONE_STAGED_MODULES(polygon_convexity)

  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "polygons",
                                     .pages = "4-6",
                                     .question = "Is the polygon convex, strictly so, and which way round does it go?",
                                     .kind = Kind::decision,
                                     .fields = {"polygon"},
                                     .margin_degree = 2,
                                     .cost = 3,
                                     .time = {.robust = Growth::linearithmic,
                                              .oracle = Growth::linearithmic,
                                              .ask = Growth::linearithmic,
                                              .reference = Growth::quadratic},
                                     .list_length = 4};

  /// The vertex `later` places after vertex i comes again, or a point of the edge there, between vertex i and the next.
  static Polygon2d pinched(Polygon2d ring, DrawStream& c, bool at_vertex) {
    const std::size_t i = c.below(ring.size()), k = (i + 2 + c.below(ring.size() - 2)) % ring.size();
    for (Point2d& p : ring.vertices) p = {2 * p.x, 2 * p.y};
    const Point2d p = ring[k], q = ring.next(k), again = at_vertex ? p : Point2d{(p.x + q.x) / 2, (p.y + q.y) / 2};
    ring.vertices.insert(ring.vertices.begin() + static_cast<std::ptrdiff_t>(i + 1), again);
    return ring;
  }

  static void hard_cases(HardCases<Question>& add) {
    add("convex", [](DrawStream& c) -> Question { return turned(convex_ring(c), c); });
    add("concave",
        [](DrawStream& c) -> Question { return c.coin() ? turned(comb_ring(c), c) : turned(star_ring(c), c); });
    add("flat_vertex", [](DrawStream& c) -> Question {
      Polygon2d ring = with_flat_vertex(simple_ring(c), c);
      return turned(c.coin() ? with_flat_vertex(ring, c) : ring, c);
    });
    add("flat_on_the_left", [](DrawStream& c) -> Question {
      // The first vertices from the left are on one line, and the middle one may come first.
      const double height = 2 + up_to(c, 19), width = 2 + std::fabs(integer(c, 20)), dent = up_to(c, 1);
      return turned({{{0, 1}, {0, 0}, {width, 0}, {width - dent, 1}, {width, height}, {0, height}}}, c);
    });
    add("nearly_flat", [](DrawStream& c) -> Question { return nearly_flat_ring(c); });
    add("all_on_a_line", [](DrawStream& c) -> Question {
      const auto [p, v] = lattice_line(c);
      Polygon2d ring;
      for (std::uint64_t left = 3 + c.below(4); left > 0; --left)
        ring.vertices.push_back(along(p, small_integer(c), v));
      return ring;
    });
    add("repeated_vertex",
        [](DrawStream& c) -> Question { return turned(with_repeated_vertex(simple_ring(c), c), c); });
    add("spike", [](DrawStream& c) -> Question { return turned(with_spike(simple_ring(c), c), c); });
    add("vertex_on_edge", [](DrawStream& c) -> Question { return turned(pinched(simple_ring(c), c, false), c); });
    add("vertex_on_vertex", [](DrawStream& c) -> Question { return turned(pinched(simple_ring(c), c, true), c); });
    add("crossing", [](DrawStream& c) -> Question {
      Polygon2d ring = simple_ring(c);
      const std::size_t i = c.below(ring.size());
      std::swap(ring.vertices[i], ring.vertices[(i + 1 + c.below(ring.size() - 1)) % ring.size()]);
      return ring;
    });
    add("many_times_round", [](DrawStream& c) -> Question {
      // Every second vertex, going on until the first comes: each turn is to one side.
      const Polygon2d once = convex_ring(c);
      const std::size_t step = 1 + c.below(2), rounds = 1 + c.below(3);
      Polygon2d ring;
      for (std::size_t i = 0; i < once.size() * rounds; ++i) ring.vertices.push_back(once[i * step % once.size()]);
      return turned(ring, c);
    });
    add("typed_flat", [](DrawStream& c) -> Question { return typed_flat_ring(c); });
    add("far_from_origin", [](DrawStream& c) -> Question {
      Polygon2d ring = convex_ring(c);
      for (Point2d& p : ring.vertices) p = {1e6 + 0.1 * p.x, 1e6 + 0.1 * p.y};
      return turned(c.coin() ? with_flat_vertex(ring, c) : ring, c);
    });
    add("flat_runs", [](DrawStream& c) -> Question { return turned(with_flat_runs(simple_ring(c), c), c); });
    add("computed", [](DrawStream& c) -> Question {
      Polygon2d ring = c.coin() ? simple_ring(c) : convex_ring(c);
      ring = with_flat_runs(ring, c);
      compute(ring.vertices, c);
      return turned(ring, c);
    });
    add("closed_ring", [](DrawStream& c) -> Question {
      const Polygon2d ring = c.coin() ? simple_ring(c) : convex_ring(c);
      return closed(turned(ring, c), c);
    });
  }

  /// (12, 12) lies on the line from (1/2, 1/2), which moves, to (24, 24).
  static Question map_centre() { return {{{{12, 12}, {24, 24}, {0, 30}, {0.5, 0.5}}}}; }

  /// Any ring is a question. Drawn without a plan nearly all would cross themselves, so those of even length do not.
  static void repair(Question& question) {
    Polygon2d& ring = std::get<0>(question);
    if (ring.size() % 2 == 0) untangle(ring);
  }

  static Hooks<polygon_convexity> hooks() {
    return {.repair = repair,
            .map_centre = map_centre,
            .laws = {.maps = Laws::Maps::affine, .scales = true, .reflected = {{"ccw", "cw"}}}};
  }
};

}  // namespace touchstone::catalogue::rows
