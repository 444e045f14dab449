// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "catalogue/families/closest_draws.h"
#include "catalogue/families/reported_triangles.h"
#include "catalogue/families/triangles/triangle_pairs.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/rows/polyhedra/triangle_triangle.h"
#include "catalogue/signatures/mixed/triangle_triangle_distance.h"
#include "oracle/mixed/triangle_triangle_distance.h"
#include "reference/mixed/triangle_triangle_distance.h"
#include "robust/mixed/triangle_triangle_distance.h"

namespace touchstone::catalogue::rows {

struct triangle_triangle_distance : signatures::triangle_triangle_distance {
  TOUCHSTONE_STAGED_MODULES(triangle_triangle_distance)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "mixed",
      .pages = "9, 12-13, 48-50, 54",
      .question = "Which points of two triangles in space are nearest to each other, and how far is it?",
      .kind = Kind::measure,
      .fields = {"a", "b"},
      .ulps = 66,
      .margin_degree = 2,
      .cost = 20,
      .longest_vector = 4000};

  static void hard_cases(HardCases<Question>& add) {
    add("crossing", moved_apart<crossing_triangles>);
    add("common_edge", moved_apart<edges_on_a_line>);
    add("corner_on", moved_apart<corner_on_triangle>);
    add("edge_on_edge", moved_apart<edge_on_edge>);
    add("small_lattice", two<small_lattice_point>);
    add("coplanar", coplanar_triangles<&CoplanarDraws::other_triangle>);
    add("coplanar_at_edge", coplanar_triangles<&CoplanarDraws::triangle_at_edge>);
    add("coplanar_within", coplanar_triangles<&CoplanarDraws::triangle_within>);
    add("over_face", triangle_over_face);
    add("edge_over_edge", edges_over_each_other);
    add("an_ulp_apart", [](DrawStream& c) -> Question {
      auto [a, b] = c.coin() ? edge_on_edge(c) : corner_on_triangle(c);
      const double far = small_integer(c, 1), side = small_integer(c, 1);
      for (Triangle3d* t : {&a, &b})
        for (Point3d* p : {&t->a, &t->b, &t->c}) p->x += std::ldexp(far, 20);
      for (Point3d* p : {&b.a, &b.b, &b.c}) p->x = std::nextafter(p->x, p->x + side);
      return {a, b};
    });
    add("no_area", triangles_without_area);
    add("needles", moved_apart<crossing_needles>);
    add("corner_rounded_onto", corner_rounded_onto);
    add("long_coplanar", long_coplanar);
    add("rounding", [](DrawStream& c) -> Question {
      // Over the face, whose normal is along a diagonal: x and y of the foot are half a step further, and x is
      // halfway between two doubles.
      const double x = halfway_number(c);
      const double odd = 1 + 2 * up_to(c, 7), z = small_integer(c, 3), far = one_to(c, 8);
      const Point3d p{x + odd, hair(c), z};
      return {{{x, 0, -64}, {x + 64, 64, -64}, {x, 0, 64}},
              {p, {p.x + far, -far, z + far}, {p.x + far, -far, z - far}}};
    });
    add("rounding_of_distance", [](DrawStream& c) -> Question {
      const HalfwayStep step = halfway_step(c);
      const Triangle3d t{{-1, 0, 0}, {0, -1, 0}, {0, 0, 0}};
      return in_either_order(c, t, {{step.x, step.y, hair(c)}, {2 * step.x, step.y, 0}, {step.x, 2 * step.y, 0}});
    });
    add("stretched", [](DrawStream& c) -> Question {
      Question question = moved_apart<crossing_triangles>(c);
      auto& [a, b] = question;
      Stretch{c}(a, b);
      return question;
    });
    add("reported", [](DrawStream& c) -> Question { return reported_triangles(c); });
    add("typed_shapes", two<typed_point>);
    add("subnormal", [](DrawStream& c) -> Question {
      const Triangle3d t = triangle_of(c, subnormal_point);
      return {t, c.coin() ? triangle_of(c, subnormal_point) : triangle_of(c, small_lattice_point)};
    });
    add("whole_range", two<point_of_full_range>);
    add("either_zero", [](DrawStream& c) -> Question {
      const Point3d p = zero_point(c), q = zero_point(c), r = zero_point(c);
      const double far = small_integer(c, 1);
      return {{p, {1, q.y, q.z}, {r.x, 1, r.z}}, {{p.x, p.y, far}, {q.x, 1, far}, {1, r.y, far}}};
    });
  }

  /// Without their edges they meet where those of triangle_triangle do.
  static std::optional<ConvexDistance<TrueNumber>> as_open_sets(const ConvexDistance<TrueNumber>& truth,
                                                                const Question& question) {
    if (truth.relation == ConvexRelation::apart) return std::nullopt;
    if (!triangle_triangle::as_open_sets(TriangleTriangleRelation::point, question)) return std::nullopt;
    return ConvexDistance<TrueNumber>{ConvexRelation::apart, {}, {}, {}, {}};
  }

  /// Two triangles whose edges cross in (24, 24, 24); moves a corner of the first.
  static Question map_centre() {
    return {{{0.5, 0.5, 0.5}, {48, 48, 48}, {0, 48, 0}}, {{24, 24, 3}, {24, 24, 45}, {60, 0, 24}}};
  }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<triangle_triangle_distance> hooks() {
    return {.as_open_sets = as_open_sets,
            .as_near = as_near_to_answer<triangle_triangle_distance>,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::axes}};
  }

 private:
  template <auto point>
  static Question two(DrawStream& c) {
    return {triangle_of(c, point), triangle_of(c, point)};
  }
};

}  // namespace touchstone::catalogue::rows
