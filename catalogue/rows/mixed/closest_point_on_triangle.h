// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/closest_draws.h"
#include "catalogue/operation/row.h"
#include "oracle/mixed/closest_point_on_triangle.h"
#include "reference/mixed/closest_point_on_triangle.h"
#include "reference/standard/point_and_triangle.h"
#include "robust/mixed/closest_point_on_triangle.h"

namespace touchstone::catalogue::rows {

struct closest_point_on_triangle {
  TOUCHSTONE_MODULES(closest_point_on_triangle)
  using stages = ::touchstone::robust::stages::closest_point_on_triangle;
  using Question = std::tuple<Point3d, Triangle3d>;
  using decision = NoDecision;

  static const Metadata& metadata() {
    static const Metadata metadata{.name = "closest_point_on_triangle",
                                   .chapter = "mixed",
                                   .pages = "9, 54",
                                   .question = "Which point of a triangle is nearest to the point, and how far is it?",
                                   .kind = Kind::measure,
                                   .fields = {"point", "triangle"},
                                   .ulps = 66,
                                   .margin_degree = 0,
                                   .cost = 10,
                                   .longest_vector = 2300};
    return metadata;
  }

  static void standard(const auto& add) {
    add("foot on the plane, else the nearest edge", [](const auto&... q) {
      return ::touchstone::reference::standard::closest_point_on_triangle<
          ::touchstone::reference::standard::ByFaceOrEdges>(q...);
    });
    add("Ericson, closest point of a triangle, times a reciprocal", [](const auto&... q) {
      return ::touchstone::reference::standard::closest_point_on_triangle<::touchstone::reference::standard::ByRegions>(
          q...);
    });
  }

  static std::vector<HardCase<Question>> hard_cases() {
    return {
        {"over_face_edge_or_corner",
         [](DrawStream& c) -> Question {
           const LatticePlane plane = LatticePlane::of(c, 6);
           const Triangle3d t = plane.triangle(c);
           const double height = small_integer(c);
           return {plane.point(c) + height * cross(plane.u, plane.v), t};
         }},
        {"near_corner",
         [](DrawStream& c) -> Question {
           // At a corner, or a little aside from it in or beyond the plane.
           const LatticePlane plane = LatticePlane::of(c, 6);
           const Triangle3d t = plane.triangle(c);
           const double i = small_integer(c, 1) * 0x1p-20, j = small_integer(c, 1) * 0x1p-20;
           const Vector3d aside = i * plane.u + j * plane.v + (small_integer(c, 1) * 0x1p-10) * cross(plane.u, plane.v);
           return {t.b + aside, t};
         }},
        {"near_edge",
         [](DrawStream& c) -> Question {
           // An edge along u; the point on the line of the edge, or a little aside.
           const LatticePlane plane = LatticePlane::of(c, 6);
           const double i = small_integer(c), j = small_integer(c), off = small_integer(c, 1) * 0x1p-20;
           return {plane.at(small_integer(c), off), {plane.at(i, 0), plane.at(j, 0), plane.point(c)}};
         }},
        {"in_triangle_or_plane",
         [](DrawStream& c) -> Question {
           const LatticePlane plane = LatticePlane::of(c);
           const Triangle3d t = plane.triangle(c);
           return {plane.point(c), t};
         }},
        {"small_lattice",
         [](DrawStream& c) -> Question {
           const Point3d p = small_lattice_point(c), a = small_lattice_point(c), b = small_lattice_point(c);
           return {p, {a, b, small_lattice_point(c)}};
         }},
        {"no_area",
         [](DrawStream& c) -> Question {
           const LatticePlane line = LatticePlane::of(c, 8);
           const double i = small_integer(c, 3), j = small_integer(c, 3), k = small_integer(c, 3);
           return {line.point(c), {line.at(i, 0), line.at(j, 0), line.at(k, 0)}};
         }},
        {"triangle_is_point",
         [](DrawStream& c) -> Question {
           const Point3d p = lattice_point_in_space(c, 20), q = lattice_point_in_space(c, 20);
           return {p, {q, q, q}};
         }},
        {"needle",
         [](DrawStream& c) -> Question {
           // Thousands of millions long, a few units wide, around its middle.
           const double length = std::ldexp(1, 20 + static_cast<int>(c.below(22)));
           const double y = small_integer(c, 3), z = small_integer(c, 3), x = small_integer(c, 3);
           const Triangle3d t{{-length, y, z}, {length, small_integer(c, 3), 0}, {length, 0, small_integer(c, 3)}};
           return {lattice_point_in_space(c, 4) + Vector3d{x, 0, 0}, t};
         }},
        {"rounded_onto_triangle",
         [](DrawStream& c) -> Question {
           const Point3d a = ordinary_point_in_space(c), b = ordinary_point_in_space(c), d = ordinary_point_in_space(c);
           const double s = ordinary(c), t = ordinary(c);
           return {a + (s * (b - a) + t * (d - a)), {a, b, d}};
         }},
        {"full_mantissa",
         [](DrawStream& c) -> Question {
           const LongPlane plane = LongPlane::of(c);
           const Point3d p = plane.point(c), a = plane.point(c), b = plane.point(c);
           return {c.below(2) == 1 ? ordinary_point_in_space(c) : p, {a, b, plane.point(c)}};
         }},
        {"rounding",
         [](DrawStream& c) -> Question {
           // Over the face, whose normal is along a diagonal: x and y of the foot are half a step further, and x is
           // halfway between two doubles.
           const HalfwayNumber x = halfway_number(c);
           const double odd = 1 + 2 * static_cast<double>(c.below(8)), z = small_integer(c, 3);
           return {{x.most + odd, hair(c), z}, {{x.most, 0, -64}, {x.most + 64, 64, -64}, {x.most, 0, 64}}};
         }},
        {"rounding_of_distance",
         [](DrawStream& c) -> Question {
           const HalfwayStep step = halfway_step(c);
           return {{step.x, step.y, hair(c)}, {{-1, 0, 0}, {0, -1, 0}, {0, 0, 0}}};
         }},
        {"stretched",
         [](DrawStream& c) -> Question {
           const LatticePlane plane = LatticePlane::of(c);
           Triangle3d t = plane.triangle(c);
           const Point3d foot = plane.point(c);
           Point3d p = foot + lattice_normal(c, 4);
           stretch(c, p, t.a, t.b, t.c);
           return {p, t};
         }},
        {"typed",
         [](DrawStream& c) -> Question {
           const Point3d p = typed_point(c), a = typed_point(c), b = typed_point(c);
           return {p, {a, b, typed_point(c)}};
         }},
        {"subnormal",
         [](DrawStream& c) -> Question {
           const Point3d p = subnormal_point(c), a = subnormal_point(c), b = subnormal_point(c);
           return {p, {a, b, c.below(2) == 1 ? lattice_point_in_space(c, 4) : subnormal_point(c)}};
         }},
        {"whole_range",
         [](DrawStream& c) -> Question {
           const Point3d p = point_of_whole_range(c), a = point_of_whole_range(c), b = point_of_whole_range(c);
           return {p, {a, b, point_of_whole_range(c)}};
         }},
        {"either_zero",
         [](DrawStream& c) -> Question {
           const Point3d p = zero_point(c), a = zero_point(c), b = zero_point(c), d = zero_point(c);
           const double x = static_cast<double>(c.below(2)), y = static_cast<double>(c.below(2));
           return {p, {a, x == 0 ? b : Point3d{1, b.y, b.z}, y == 0 ? d : Point3d{d.x, 1, d.z}}};
         }},
    };
  }

  /// Moves the point at the corner (24, 24, 24).
  static Question map_centre() { return {{24, 24, 24}, {{24, 24, 24}, {24, 24, 45}, {60, 24, 24}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<closest_point_on_triangle> hooks() {
    return {.map_centre = map_centre, .map_axes = map_axes, .laws = {.maps = Laws::Maps::axes}};
  }
};

}  // namespace touchstone::catalogue::rows
