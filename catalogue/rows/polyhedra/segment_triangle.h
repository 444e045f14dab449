// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/coplanar_draws.h"
#include "catalogue/families/meshes/reported_meshes.h"
#include "catalogue/families/triangle_draws.h"
#include "catalogue/operation/row.h"
#include "oracle/polyhedra/segment_triangle.h"
#include "reference/polyhedra/segment_triangle.h"
#include "reference/standard/moeller_trumbore.h"
#include "robust/batch/segment_triangle.h"
#include "robust/polyhedra/segment_triangle.h"

namespace touchstone::catalogue::rows {

struct segment_triangle {
  TOUCHSTONE_MODULES(segment_triangle)
  TOUCHSTONE_ARRAYS(segment_triangle)
  using stages = ::touchstone::robust::stages::segment_triangle;
  using Question = std::tuple<Segment3d, Triangle3d>;

  static const Metadata& metadata() {
    static const Metadata metadata{
        .name = "segment_triangle",
        .chapter = "polyhedra",
        .pages = "54",
        .question = "What do the closed segment and the closed triangle in space have in common?",
        .kind = Kind::set,
        .fields = {"segment", "triangle"},
        .ulps = 36,
        .margin_degree = 2,
        .cost = 3};
    return metadata;
  }

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

  static std::vector<HardCase<Question>> hard_cases() {
    return {
        {"crossing", crossing},
        {"small_lattice",
         [](DrawStream& c) -> Question {
           const Point3d p = small_lattice_point(c), q = small_lattice_point(c), a = small_lattice_point(c),
                         b = small_lattice_point(c);
           return {{p, q}, {a, b, small_lattice_point(c)}};
         }},
        {"through_edge",
         [](DrawStream& c) -> Question {
           const LatticePlane edge = LatticePlane::of(c);  // along u, through the origin; v across
           const double i = small_integer(c, 3), j = small_integer(c, 3);
           const Triangle3d t{edge.at(i, 0), edge.at(j, 0), lattice_point_in_space(c)};
           return {segment_through(c, edge.origin, edge.v), t};
         }},
        {"along_edge",
         [](DrawStream& c) -> Question {
           const LatticePlane edge = LatticePlane::of(c);
           const double i = small_integer(c), j = small_integer(c), k = small_integer(c), l = small_integer(c);
           return {{edge.at(i, 0), edge.at(j, 0)}, {edge.at(k, 0), edge.at(l, 0), lattice_point_in_space(c)}};
         }},
        {"coplanar",
         [](DrawStream& c) -> Question {
           const LatticePlane plane = LatticePlane::of(c);
           const Point3d p = plane.point(c), q = plane.point(c);
           return {{p, q}, plane.triangle(c)};
         }},
        {"parallel",
         [](DrawStream& c) -> Question {
           const LatticePlane plane = LatticePlane::of(c);
           const Vector3d off = lattice_normal(c);
           const Point3d p = plane.point(c) + off, q = plane.point(c) + off;
           return {{p, q}, plane.triangle(c)};
         }},
        {"zero_length",
         [](DrawStream& c) -> Question {
           const LatticePlane plane = LatticePlane::of(c);
           const Point3d p = plane.point(c);
           return {{p, p}, plane.triangle(c)};
         }},
        {"no_area",
         [](DrawStream& c) -> Question {
           const LatticePlane line = LatticePlane::of(c);
           const double i = small_integer(c, 3), j = small_integer(c, 3), k = small_integer(c, 3);
           const Triangle3d t{line.at(i, 0), line.at(j, 0), line.at(k, 0)};
           const Vector3d way = c.below(2) == 1 ? line.v : line.u;
           return {segment_through(c, line.origin, way), t};
         }},
        {"triangle_is_point",
         [](DrawStream& c) -> Question {
           const LatticePlane line = LatticePlane::of(c);
           const Point3d p = line.at(0, small_integer(c, 1));
           return {segment_through(c, line.origin, line.u), {p, p, p}};
         }},
        {"needle",
         [](DrawStream& c) -> Question {
           // Thousands of millions long, a few units wide, around its middle.
           const double length = std::ldexp(1, 30 + static_cast<int>(c.below(12)));
           const double y = small_integer(c, 3), z = small_integer(c, 3);
           const Triangle3d t{{-length, y, z}, {length, small_integer(c, 3), 0}, {length, 0, small_integer(c, 3)}};
           const double x = small_integer(c, 3);
           return {segment_through(c, {x, 0, 0}, lattice_normal(c, 4)), t};
         }},
        {"end_rounded_onto",
         [](DrawStream& c) -> Question {
           const Point3d p = ordinary_point_in_space(c), a = ordinary_point_in_space(c), b = ordinary_point_in_space(c),
                         d = ordinary_point_in_space(c);
           const double s = ordinary(c), t = ordinary(c);
           return {{p, a + (s * (b - a) + t * (d - a))}, {a, b, d}};
         }},
        {"long_coplanar",
         [](DrawStream& c) -> Question {
           const LongPlane plane = LongPlane::of(c);
           const Point3d p = plane.point(c), q = plane.point(c), a = plane.point(c), b = plane.point(c);
           return {{p, q}, {a, b, plane.point(c)}};
         }},
        {"stretched",
         [](DrawStream& c) -> Question {
           Question question = crossing(c);
           auto& [s, t] = question;
           stretch(c, s.a, s.b, t.a, t.b, t.c);
           return question;
         }},
        {"whole_range",
         [](DrawStream& c) -> Question {
           // Differences overflow, and products of what does not.
           const auto number = [&c] {
             const double n = small_integer(c, 1);
             return std::ldexp(n, c.below(2) == 1 ? 1023 : 0);
           };
           const auto point = [&number] {
             const double x = number(), y = number();
             return Point3d{x, y, number()};
           };
           const Point3d p = point(), q = point(), a = point(), b = point();
           return {{p, q}, {a, b, point()}};
         }},
        {"reported_edyn_155",
         [](DrawStream& c) -> Question {
           // Through the middle of the diagonal of a side, of which the triangle is a half, or parallel to the side.
           const Meshd cube = reported::edyn_155();
           const Face& half = cube.faces[c.below(cube.faces.size())];
           const std::uint64_t axis = c.below(3);
           const double from = c.below(2) == 0 ? 2 : -2;
           const auto at = [axis](double n) {
             return Point3d{axis == 0 ? n : 0, axis == 1 ? n : 0, axis == 2 ? n : 0};
           };
           return {{at(from), at(-from)}, {cube.vertices[half.a], cube.vertices[half.b], cube.vertices[half.c]}};
         },
         /*unscaled=*/true},
        {"coplanar_at_edge",
         [](DrawStream& c) -> Question {
           CoplanarDraws coplanar(c);
           const Segment3d s = coplanar.segment_at_edge();
           return {s, coplanar.triangle()};
         }},
        {"coplanar_within",
         [](DrawStream& c) -> Question {
           CoplanarDraws coplanar(c);
           const Segment3d s = coplanar.segment_within();
           return {s, coplanar.triangle()};
         }},
        {"coplanar_in_any_order",
         [](DrawStream& c) -> Question {
           CoplanarDraws coplanar(c);
           const Segment3d s = coplanar.segment();
           return {s, coplanar.triangle()};
         }},
    };
  }

  /// Open: without ends and edges. What has no length or no area is empty then.
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
  /// A triangle around a point, or near it, and a segment through the point.
  static Question crossing(DrawStream& c) {
    const LatticePlane plane = LatticePlane::of(c);
    const Triangle3d t = plane.triangle(c);
    return {segment_through(c, plane.origin, lattice_normal(c)), t};
  }
};

}  // namespace touchstone::catalogue::rows
