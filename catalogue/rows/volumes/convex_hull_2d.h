// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "catalogue/draw/figures.h"
#include "catalogue/families/list_draws.h"
#include "catalogue/families/long_draws.h"
#include "catalogue/families/many_points.h"
#include "catalogue/families/rings.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/volumes/convex_hull_2d.h"
#include "oracle/volumes/convex_hull_2d.h"
#include "reference/volumes/convex_hull_2d.h"
#include "robust/volumes/convex_hull_2d.h"

namespace touchstone::catalogue::rows {

struct convex_hull_2d : signatures::convex_hull_2d {
  TOUCHSTONE_STAGED_MODULES(convex_hull_2d)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "volumes",
      .pages = "35-42",
      .question = "Which of these points of the plane are the corners of their convex hull?",
      .kind = Kind::checked,
      .fields = {"points"},
      .margin_degree = 2,
      .cost = 3,
      .time = grows(Growth::linearithmic),
      .list_length = 4};

  static void hard_cases(HardCases<Question>& add) {
    add("few", [](DrawStream& c) -> Question {
      Points points{lattice_point(c)};
      for (std::uint64_t more = c.below(3); more > 0; --more) points.push_back(lattice_point(c));
      return points;
    });
    add("all_equal", [](DrawStream& c) -> Question {
      const Point2d p = lattice_point(c);
      Points points(1 + c.below(6), p);
      if (points[0].y == 0 && c.coin()) points.back().y = -0.0;
      return points;
    });
    add("collinear", [](DrawStream& c) -> Question { return on_one_line(c); });
    add("one_beside_a_line", [](DrawStream& c) -> Question {
      Points points = on_one_line(c);
      points.push_back(nudged(points[0], c));
      return points;
    });
    add("small_grid", [](DrawStream& c) -> Question {
      return one_by_one(c, 24, [](DrawStream& d) { return Point2d{small_integer(d, 2), small_integer(d, 2)}; });
    });
    add("on_a_circle", [](DrawStream& c) -> Question {
      return one_by_one(c, 24, [](DrawStream& d) {
        const Vector2d v = std::array<Vector2d, 5>{{{16, 63}, {25, 60}, {33, 56}, {39, 52}, {65, 0}}}[d.below(5)];
        const double x = either_sign(d) * v.x, y = either_sign(d) * v.y;
        return d.coin() ? Point2d{x, y} : Point2d{y, x};
      });
    });
    add("points_inside_edges",
        [](DrawStream& c) -> Question { return shuffled(with_flat_runs(convex_ring(c), c).vertices, c); });
    add("points_inside", [](DrawStream& c) -> Question {
      Points points = convex_ring(c).vertices;
      for (Point2d& p : points) p = {2 * p.x, 2 * p.y};
      for (std::uint64_t more = c.below(12); more > 0; --more) points.push_back(middle(points, c));
      return shuffled(points, c);
    });
    add("repeated",
        [](DrawStream& c) -> Question { return shuffled(with_repeated(convex_ring(c).vertices, 6, c), c); });
    add("many", [](DrawStream& c) -> Question {
      const int most = integer_in(c, 1, 64);
      Points points(32 + c.below(64));
      for (Point2d& p : points) p = {small_integer(c, most), small_integer(c, most)};
      return points;
    });
    add("many_inside_two_edges", [](DrawStream& c) -> Question {
      // Nothing is left out but what lies strictly inside: most points lie on the diagonals of a square.
      Points points{{-64, -64}, {64, 64}, {-64, 64}, {64, -64}};
      for (std::uint64_t left = 28 + c.below(20); left > 0; --left) {
        const double x = small_integer(c, 64);
        points.push_back({x, c.one_in(4) ? 64 : x});
      }
      return shuffled(points, c);
    });
    add("tiny_beside_huge", [](DrawStream& c) -> Question {
      return one_by_one(c, 12, [](DrawStream& d) {
        const Point2d p = lattice_point(d, 10);
        const int k = std::array{0, 60, -60, 1000, -1074}[d.below(5)];
        return Point2d{std::ldexp(p.x, k), std::ldexp(p.y, k)};
      });
    });
    add("beside_least_edge", [](DrawStream& c) -> Question {
      auto [ring, point] = beside_least_edge(c);
      ring.vertices.push_back(point);
      return shuffled(ring.vertices, c);
    });
    add("long_lines", [](DrawStream& c) -> Question {
      const LongTriple one = long_triple(c), other = long_triple(c);
      return shuffled(Points{one.first, one.last, one.between, other.first, other.last, other.between}, c);
    });
    add("computed", [](DrawStream& c) -> Question {
      Points points = with_flat_runs(convex_ring(c), c).vertices;
      compute(points, c);
      return shuffled(points, c);
    });
    add.unscaled("many_points", [](DrawStream& c) -> Question {
      Points points;
      for (const Point3d& p : many_points_and_one_far(c)) points.push_back({p.x, p.y});
      return points;
    });
  }

  static std::string defect(const Question& question, const ConvexHull2& hull) {
    return ::touchstone::oracle::convex_hull_2d_defect(std::get<0>(question), hull);
  }
  static Excess excess(const Question& question, const ConvexHull2& hull, const ConvexHull2&) {
    return excess_of_hull(std::get<0>(question), hull);
  }

  static void draw(Drawing& drawing, const Question& question, const ConvexHull2& hull) {
    const Points& points = std::get<0>(question);
    for (std::size_t i = 0; i < points.size(); ++i) catalogue::draw(drawing, std::to_string(i), points[i], false);
    if (hull.segment) catalogue::draw(drawing, "", Segment2d{points[hull.segment->i], points[hull.segment->j]}, true);
    Polygon2d polygon;
    for (const Index i : hull.polygon.value_or(std::vector<Index>())) polygon.vertices.push_back(points[i]);
    if (hull.polygon) catalogue::draw(drawing, "", polygon, true);
  }

  /// A point inside an edge.
  static Question map_centre() { return {{{12, 12}, {24, 24}, {0, 24}, {0.5, 0.5}}}; }

  static Hooks<convex_hull_2d> hooks() {
    return {.defect = defect, .excess = excess, .map_centre = map_centre, .draw = draw};
  }

 private:
  static Points on_one_line(DrawStream& c) {
    const Point2d p = lattice_point(c);
    const Vector2d v = lattice_direction(c);
    return one_by_one(c, 12, [&](DrawStream& d) { return along(p, small_integer(d), v); });
  }
  /// The middle of two points, exact if both are even.
  static Point2d middle(const Points& points, DrawStream& c) {
    const Point2d p = points[c.below(points.size())], q = points[c.below(points.size())];
    return {p.x / 2 + q.x / 2, p.y / 2 + q.y / 2};
  }
};

}  // namespace touchstone::catalogue::rows
