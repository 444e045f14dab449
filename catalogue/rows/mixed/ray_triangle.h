// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/triangle_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/ray_triangle.h"
#include "oracle/mixed/ray_triangle.h"
#include "reference/mixed/ray_triangle.h"
#include "reference/standard/moeller_trumbore.h"
#include "robust/batch/ray_triangle.h"
#include "robust/mixed/ray_triangle.h"

namespace touchstone::catalogue::rows {

struct ray_triangle : signatures::ray_triangle {
  TOUCHSTONE_STAGED_MODULES(ray_triangle)
  TOUCHSTONE_ARRAYS(ray_triangle)

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "mixed",
                                     .pages = "9, 54",
                                     .question = "What do the ray and the closed triangle in space have in common?",
                                     .kind = Kind::set,
                                     .fields = {"ray", "triangle"},
                                     .ulps = 31,
                                     .margin_degree = 2,
                                     .cost = 3};

  struct decision {
    static SegmentTriangleRelation robust(const Question& q) {
      return ::touchstone::robust::ray_triangle_relation(std::get<0>(q), std::get<1>(q));
    }
  };

  static void standard(const auto& add) {
    add("Moeller and Trumbore, times the reciprocal of the determinant", [](const auto&... q) {
      return ::touchstone::reference::standard::ray_triangle<::touchstone::reference::standard::ByReciprocal>(q...);
    });
    add("Moeller and Trumbore, undivided", [](const auto&... q) {
      return ::touchstone::reference::standard::ray_triangle<::touchstone::reference::standard::ByDeterminant>(q...);
    });
  }

  static void hard_cases(HardCases<Question>& add) {
    add("crossing", crossing);
    add("small_lattice", [](DrawStream& c) -> Question {
      const Point3d p = small_lattice_point(c), q = small_lattice_point(c), a = small_lattice_point(c),
                    b = small_lattice_point(c);
      return {from_to(p, q), {a, b, small_lattice_point(c)}};
    });
    add("through_edge", [](DrawStream& c) -> Question {
      const LatticePlane edge = LatticePlane::of(c);  // along u, through the origin; v across
      const Triangle3d t{edge.on_line(c), edge.on_line(c), lattice_point_in_space(c)};
      return {ray_to(c, edge.origin, edge.v), t};
    });
    add("along_edge", [](DrawStream& c) -> Question {
      const LatticePlane edge = LatticePlane::of(c);
      const double i = small_integer(c), j = small_integer(c), k = small_integer(c), l = small_integer(c);
      return {from_to(edge.at(i, 0), edge.at(j, 0)), {edge.at(k, 0), edge.at(l, 0), lattice_point_in_space(c)}};
    });
    add("coplanar", [](DrawStream& c) -> Question {
      const LatticePlane plane = LatticePlane::of(c);
      const Point3d p = plane.point(c), q = plane.point(c);
      return {from_to(p, q), plane.triangle(c)};
    });
    add("parallel", [](DrawStream& c) -> Question {
      const LatticePlane plane = LatticePlane::of(c);
      const Vector3d off = lattice_normal(c);
      const Point3d p = plane.point(c) + off, q = plane.point(c) + off;
      return {from_to(p, q), plane.triangle(c)};
    });
    add("starts_on_triangle", [](DrawStream& c) -> Question {
      const LatticePlane plane = LatticePlane::of(c);
      const Triangle3d t = plane.triangle(c);
      return {{plane.origin, lattice_normal(c)}, t};
    });
    add("no_area", [](DrawStream& c) -> Question {
      const LatticePlane line = LatticePlane::of(c);
      const Triangle3d t = line.triangle_without_area(c);
      return {ray_to(c, line.origin, c.coin() ? line.v : line.u), t};
    });
    add("triangle_is_point", [](DrawStream& c) -> Question {
      const LatticePlane line = LatticePlane::of(c);
      const Point3d p = line.at(0, small_integer(c, 1));
      return {ray_to(c, line.origin, line.u), {p, p, p}};
    });
    add("needle", [](DrawStream& c) -> Question {
      const Triangle3d t = needle(c, 30, 41);
      const double x = small_integer(c, 3);
      return {ray_to(c, {x, 0, 0}, lattice_normal(c, 4)), t};
    });
    add("from_far_away", [](DrawStream& c) -> Question {
      // A thousand million times as far as the triangle is large, aimed at a point near a corner or on it.
      const double far = -power_of_two(c, 20, 50);
      const Vector3d displacement = lattice_normal(c, 2);
      return {{along({small_integer(c, 1), small_integer(c, 1), 0}, far, displacement), displacement},
              {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    });
    add("direction_of_any_size", [](DrawStream& c) -> Question {
      Question question = crossing(c);
      Vector3d& v = std::get<0>(question).direction;
      v = scaled(v, integer_in(c, -1060, 979));
      return question;
    });
    add("origin_rounded_onto", [](DrawStream& c) -> Question {
      const Point3d p = ordinary_point_in_space(c);
      const Triangle3d t = triangle_of(c, ordinary_point_in_space);
      const Point3d on = rounded_onto(t, c);
      return {c.coin() ? Ray3d{on, p - on} : Ray3d{p, on - p}, t};
    });
    add("long_coplanar", [](DrawStream& c) -> Question {
      const LongPlane plane = LongPlane::of(c);
      const Point3d p = plane.point(c), q = plane.point(c);
      return {{p, {q.x, q.y, q.z}}, {plane.point(c), plane.point(c), plane.point(c)}};
    });
    add("stretched", [](DrawStream& c) -> Question {
      Question question = crossing(c);
      auto& [r, t] = question;
      Stretch{c}(r, t);
      return question;
    });
    add("whole_range", [](DrawStream& c) -> Question {
      const Point3d p = huge_or_small_point(c), q = huge_or_small_point(c);
      return {{p, {q.x, q.y, q.z}}, triangle_of(c, huge_or_small_point)};
    });
    add("nearly_zero", [](DrawStream& c) -> Question {
      // Coordinates that rounding leaves where 0 is meant, and the greatest and least numbers that are enclosed.
      const double far = power_of_two(c, 38, 42), least = power_of_two(c, -82, -78);
      const auto near_zero = [&] { return small_integer(c, 1) * least; };
      return {{{near_zero(), near_zero(), -1}, {near_zero(), near_zero(), 1}},
              {{far, near_zero(), near_zero()}, {-far, far, near_zero()}, {-far, -far, near_zero()}}};
    });
  }

  /// Open: without the origin and the edges. A triangle without area is empty then.
  static std::optional<RayTriangle<mpq_class>> as_open_sets(const RayTriangle<mpq_class>& truth,
                                                            const Question& question) {
    const RayTriangle<mpq_class> none{SegmentTriangleRelation::none, {}, {}, {}};
    const bool touch = truth.relation == SegmentTriangleRelation::point &&
                       (sgn(*truth.t) == 0 || *truth.location == Location::boundary);
    const auto& [ray, t] = question;
    if (touch) return none;
    if (truth.relation != SegmentTriangleRelation::segment) return std::nullopt;
    // Along an edge, or in a triangle without area, all that is common is on the ray's line, and so are two corners.
    const auto on_line = [&ray = ray](const Point3d& corner) {
      const auto exact = [](const auto& p) {
        return Point3<mpq_class>{exact_value(p.x), exact_value(p.y), exact_value(p.z)};
      };
      const Vector3<mpq_class> turn =
          cross(exact(ray.direction) - Point3<mpq_class>{0, 0, 0}, exact(corner) - exact(ray.origin));
      return sgn(turn.x) == 0 && sgn(turn.y) == 0 && sgn(turn.z) == 0;
    };
    return on_line(t.a) + on_line(t.b) + on_line(t.c) >= 2 ? std::optional(none) : std::nullopt;
  }

  /// A ray along the diagonal through (24, 24, 24) on an edge of the triangle; moves its origin.
  static Question map_centre() { return {{{0.5, 0.5, 0.5}, {1, 1, 1}}, {{24, 24, 3}, {24, 24, 45}, {60, 24, 24}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<ray_triangle> hooks() {
    return {.as_open_sets = as_open_sets,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::affine, .scales = true}};
  }

 private:
  static Ray3d from_to(const Point3d& p, const Point3d& q) { return {p, q - p}; }

  /// From before the point, from it, or from behind, along the way or against it.
  static Ray3d ray_to(DrawStream& c, const Point3d& x, const Vector3d& displacement) {
    const double before = small_integer(c, 2), length = one_to(c, 3);
    return {along(x, -before - 1, displacement), (either_sign(c) * length) * displacement};
  }

  /// A triangle around a point, or near it, and a ray to the point.
  static Question crossing(DrawStream& c) {
    const LatticePlane plane = LatticePlane::of(c);
    const Triangle3d t = plane.triangle(c);
    return {ray_to(c, plane.origin, lattice_normal(c)), t};
  }
};

}  // namespace touchstone::catalogue::rows
