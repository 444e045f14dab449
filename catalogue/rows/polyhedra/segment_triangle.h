// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/coplanar_draws.h"
#include "catalogue/families/meshes/reported_meshes.h"
#include "catalogue/families/triangle_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/polyhedra/segment_triangle.h"
#include "oracle/polyhedra/segment_triangle.h"
#include "reference/polyhedra/segment_triangle.h"
#include "reference/standard/moeller_trumbore.h"
#include "robust/batch/segment_triangle.h"
#include "robust/polyhedra/segment_triangle.h"

namespace touchstone::catalogue::rows {

struct segment_triangle : signatures::segment_triangle {
  TOUCHSTONE_STAGED_MODULES(segment_triangle)
  TOUCHSTONE_ARRAYS(segment_triangle)

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "polyhedra",
      .pages = "54",
      .question = "What do the closed segment and the closed triangle in space have in common?",
      .kind = Kind::set,
      .fields = {"segment", "triangle"},
      .ulps = 36,
      .margin_degree = 2,
      .cost = 3};

  struct decision {
    static SegmentTriangleRelation robust(const Question& q) {
      return ::touchstone::robust::segment_triangle_relation(std::get<0>(q), std::get<1>(q));
    }
  };

  static void standard(const auto& add) {
    add("Moeller and Trumbore, times the reciprocal of the determinant", [](const auto&... q) {
      return ::touchstone::reference::standard::segment_triangle<::touchstone::reference::standard::ByReciprocal>(q...);
    });
    add("Moeller and Trumbore, undivided", [](const auto&... q) {
      return ::touchstone::reference::standard::segment_triangle<::touchstone::reference::standard::ByDeterminant>(
          q...);
    });
  }

  static void hard_cases(HardCases<Question>& add) {
    add("crossing", crossing);
    add("small_lattice", [](DrawStream& c) -> Question {
      return {{small_lattice_point(c), small_lattice_point(c)}, triangle_of(c, small_lattice_point)};
    });
    add("through_edge", [](DrawStream& c) -> Question {
      const LatticePlane edge = LatticePlane::of(c);  // along u, through the origin; v across
      const Triangle3d t{edge.on_line(c), edge.on_line(c), lattice_point_in_space(c)};
      return {segment_through(c, edge.origin, edge.v), t};
    });
    add("along_edge", [](DrawStream& c) -> Question {
      const LatticePlane edge = LatticePlane::of(c);
      return {{edge.on_line(c, 8), edge.on_line(c, 8)},
              {edge.on_line(c, 8), edge.on_line(c, 8), lattice_point_in_space(c)}};
    });
    add("coplanar", [](DrawStream& c) -> Question {
      const LatticePlane plane = LatticePlane::of(c);
      return {{plane.point(c), plane.point(c)}, plane.triangle(c)};
    });
    add("parallel", [](DrawStream& c) -> Question {
      const LatticePlane plane = LatticePlane::of(c);
      const Vector3d off = lattice_normal(c);
      return {{plane.point(c) + off, plane.point(c) + off}, plane.triangle(c)};
    });
    add("zero_length", [](DrawStream& c) -> Question {
      const LatticePlane plane = LatticePlane::of(c);
      const Point3d p = plane.point(c);
      return {{p, p}, plane.triangle(c)};
    });
    add("no_area", [](DrawStream& c) -> Question {
      const LatticePlane line = LatticePlane::of(c);
      const Triangle3d t = line.triangle_without_area(c);
      return {segment_through(c, line.origin, c.coin() ? line.v : line.u), t};
    });
    add("triangle_is_point", [](DrawStream& c) -> Question {
      const LatticePlane line = LatticePlane::of(c);
      const Point3d p = line.at(0, small_integer(c, 1));
      return {segment_through(c, line.origin, line.u), {p, p, p}};
    });
    add("needle", [](DrawStream& c) -> Question {
      const Triangle3d t = needle(c, 30, 41);
      const double x = small_integer(c, 3);
      return {segment_through(c, {x, 0, 0}, lattice_normal(c, 4)), t};
    });
    add("end_rounded_onto", [](DrawStream& c) -> Question {
      const Point3d p = ordinary_point_in_space(c);
      const Triangle3d t = triangle_of(c, ordinary_point_in_space);
      return {{p, rounded_onto(t, c)}, t};
    });
    add("long_coplanar", [](DrawStream& c) -> Question {
      const LongPlane plane = LongPlane::of(c);
      return {{plane.point(c), plane.point(c)}, {plane.point(c), plane.point(c), plane.point(c)}};
    });
    add("stretched", [](DrawStream& c) -> Question {
      Question question = crossing(c);
      auto& [s, t] = question;
      Stretch{c}(s, t);
      return question;
    });
    add("whole_range", [](DrawStream& c) -> Question {
      return {{huge_or_small_point(c), huge_or_small_point(c)}, triangle_of(c, huge_or_small_point)};
    });
    add.unscaled("reported_edyn_155", [](DrawStream& c) -> Question {
      // Through the middle of the diagonal of a side, of which the triangle is a half, or parallel to the side.
      const Meshd cube = reported::edyn_155();
      const Face& half = cube.faces[c.below(cube.faces.size())];
      const std::uint64_t axis = c.below(3);
      const double from = c.coin() ? -2 : 2;
      const auto at = [axis](double n) { return Point3d{axis == 0 ? n : 0, axis == 1 ? n : 0, axis == 2 ? n : 0}; };
      return {{at(from), at(-from)}, {cube.vertices[half.a], cube.vertices[half.b], cube.vertices[half.c]}};
    });
    add("coplanar_at_edge", coplanar<&CoplanarDraws::segment_at_edge>);
    add("coplanar_within", coplanar<&CoplanarDraws::segment_within>);
    add("coplanar_in_any_order", coplanar<&CoplanarDraws::segment>);
  }

  /// Open: without ends and edges. A segment without length or a triangle without area is empty then.
  static std::optional<SegmentTriangle<mpq_class>> as_open_sets(const SegmentTriangle<mpq_class>& truth,
                                                                const Question& question) {
    const SegmentTriangle<mpq_class> none{SegmentTriangleRelation::none, {}, {}, {}};
    if (truth.relation == SegmentTriangleRelation::point && sgn(*ask_oracle<segment_triangle>(question).margin) == 0)
      return none;
    if (truth.relation != SegmentTriangleRelation::segment) return std::nullopt;
    const Triangle3d& t = std::get<1>(question);
    const auto exact = [](const Point3d& p) {
      return Point3<mpq_class>{exact_value(p.x), exact_value(p.y), exact_value(p.z)};
    };
    for (const auto& [from, to] : {std::pair{t.a, t.b}, std::pair{t.b, t.c}, std::pair{t.c, t.a}}) {
      const auto off_edge = [start = exact(from), edge = exact(to) - exact(from)](const Point3<mpq_class>& p) {
        const Vector3<mpq_class> turn = cross(edge, p - start);
        return sgn(turn.x) != 0 || sgn(turn.y) != 0 || sgn(turn.z) != 0;
      };
      if (!off_edge(truth.overlap->a) && !off_edge(truth.overlap->b)) return none;
    }
    return std::nullopt;
  }

  /// A segment along the diagonal through (24, 24, 24) on an edge of the triangle; moves its beginning.
  static Question map_centre() { return {{{0.5, 0.5, 0.5}, {48, 48, 48}}, {{24, 24, 3}, {24, 24, 45}, {60, 24, 24}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<segment_triangle> hooks() {
    return {.as_open_sets = as_open_sets,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::affine, .scales = true}};
  }

 private:
  template <auto segment>
  static Question coplanar(DrawStream& c) {
    CoplanarDraws draws(c);
    return {(draws.*segment)(), draws.triangle()};
  }

  /// A triangle around a point, or near it, and a segment through the point.
  static Question crossing(DrawStream& c) {
    const LatticePlane plane = LatticePlane::of(c);
    const Triangle3d t = plane.triangle(c);
    return {segment_through(c, plane.origin, lattice_normal(c)), t};
  }
};

}  // namespace touchstone::catalogue::rows
