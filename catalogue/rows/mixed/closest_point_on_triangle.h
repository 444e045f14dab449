// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/closest_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/closest_point_on_triangle.h"
#include "oracle/mixed/closest_point_on_triangle.h"
#include "reference/mixed/closest_point_on_triangle.h"
#include "reference/standard/point_and_triangle.h"
#include "robust/mixed/closest_point_on_triangle.h"

namespace touchstone::catalogue::rows {

struct closest_point_on_triangle : signatures::closest_point_on_triangle {
  TOUCHSTONE_STAGED_MODULES(closest_point_on_triangle)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "mixed",
      .pages = "9, 54",
      .question = "Which point of a triangle is nearest to the point, and how far is it?",
      .kind = Kind::measure,
      .fields = {"point", "triangle"},
      .ulps = 66,
      .margin_degree = 0,
      .cost = 10,
      .longest_vector = 2300};

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

  static void hard_cases(HardCases<Question>& add) {
    add("over_face_edge_or_corner", [](DrawStream& c) -> Question {
      const LatticePlane plane = LatticePlane::of(c, 6);
      const Triangle3d t = plane.triangle(c);
      const double height = small_integer(c);
      return {plane.point(c) + height * cross(plane.u, plane.v), t};
    });
    add("near_corner", [](DrawStream& c) -> Question {
      // At a corner, or a little aside from it in or beyond the plane.
      const LatticePlane plane = LatticePlane::of(c, 6);
      const Triangle3d t = plane.triangle(c);
      const double i = small_integer(c, 1) * 0x1p-20, j = small_integer(c, 1) * 0x1p-20;
      const Vector3d aside = i * plane.u + j * plane.v + (small_integer(c, 1) * 0x1p-10) * cross(plane.u, plane.v);
      return {t.b + aside, t};
    });
    add("near_edge", [](DrawStream& c) -> Question {
      // An edge along u; the point on the line of the edge, or a little aside.
      const LatticePlane plane = LatticePlane::of(c, 6);
      const double i = small_integer(c), j = small_integer(c), off = small_integer(c, 1) * 0x1p-20;
      return {plane.at(small_integer(c), off), {plane.at(i, 0), plane.at(j, 0), plane.point(c)}};
    });
    add("in_triangle_or_plane", [](DrawStream& c) -> Question {
      const LatticePlane plane = LatticePlane::of(c);
      const Triangle3d t = plane.triangle(c);
      return {plane.point(c), t};
    });
    add("small_lattice", [](DrawStream& c) -> Question {
      return {small_lattice_point(c), {small_lattice_point(c), small_lattice_point(c), small_lattice_point(c)}};
    });
    add("no_area", [](DrawStream& c) -> Question {
      const LatticePlane line = LatticePlane::of(c, 8);
      const double i = small_integer(c, 3), j = small_integer(c, 3), k = small_integer(c, 3);
      return {line.point(c), {line.at(i, 0), line.at(j, 0), line.at(k, 0)}};
    });
    add("triangle_is_point", [](DrawStream& c) -> Question {
      const Point3d p = lattice_point_in_space(c, 20), q = lattice_point_in_space(c, 20);
      return {p, {q, q, q}};
    });
    add("needle", [](DrawStream& c) -> Question {
      // Thousands of millions long, a few units wide, around its middle.
      const double length = power_of_two(c, 20, 41);
      const double y = small_integer(c, 3), z = small_integer(c, 3), x = small_integer(c, 3);
      const Triangle3d t{{-length, y, z}, {length, small_integer(c, 3), 0}, {length, 0, small_integer(c, 3)}};
      return {lattice_point_in_space(c, 4) + Vector3d{x, 0, 0}, t};
    });
    add("rounded_onto_triangle", [](DrawStream& c) -> Question {
      const Point3d a = ordinary_point_in_space(c), b = ordinary_point_in_space(c), d = ordinary_point_in_space(c);
      const double s = ordinary(c), t = ordinary(c);
      return {a + (s * (b - a) + t * (d - a)), {a, b, d}};
    });
    add("full_mantissa", [](DrawStream& c) -> Question {
      const LongPlane plane = LongPlane::of(c);
      const Point3d p = plane.point(c), a = plane.point(c), b = plane.point(c);
      return {c.coin() ? ordinary_point_in_space(c) : p, {a, b, plane.point(c)}};
    });
    add("rounding", [](DrawStream& c) -> Question {
      // Over the face, whose normal is along a diagonal: x and y of the foot are half a step further, and x is
      // halfway between two doubles.
      const double x = halfway_number(c);
      const double odd = 1 + 2 * up_to(c, 7), z = small_integer(c, 3);
      return {{x + odd, hair(c), z}, {{x, 0, -64}, {x + 64, 64, -64}, {x, 0, 64}}};
    });
    add("rounding_of_distance", [](DrawStream& c) -> Question {
      const HalfwayStep step = halfway_step(c);
      return {{step.x, step.y, hair(c)}, {{-1, 0, 0}, {0, -1, 0}, {0, 0, 0}}};
    });
    add("stretched", [](DrawStream& c) -> Question {
      const LatticePlane plane = LatticePlane::of(c);
      Triangle3d t = plane.triangle(c);
      const Point3d foot = plane.point(c);
      Point3d p = foot + lattice_normal(c, 4);
      Stretch{c}(p, t);
      return {p, t};
    });
    add("typed_shapes", [](DrawStream& c) -> Question {
      return {typed_point(c), {typed_point(c), typed_point(c), typed_point(c)}};
    });
    add("subnormal", [](DrawStream& c) -> Question {
      const Point3d p = subnormal_point(c), a = subnormal_point(c), b = subnormal_point(c);
      return {p, {a, b, c.coin() ? lattice_point_in_space(c, 4) : subnormal_point(c)}};
    });
    add("whole_range", [](DrawStream& c) -> Question {
      return {point_of_full_range(c), {point_of_full_range(c), point_of_full_range(c), point_of_full_range(c)}};
    });
    add("either_zero", [](DrawStream& c) -> Question {
      const Point3d p = zero_point(c), a = zero_point(c), b = zero_point(c), d = zero_point(c);
      const double x = up_to(c, 1), y = up_to(c, 1);
      return {p, {a, x == 0 ? b : Point3d{1, b.y, b.z}, y == 0 ? d : Point3d{d.x, 1, d.z}}};
    });
  }

  /// Moves the point at the corner (24, 24, 24).
  static Question map_centre() { return {{24, 24, 24}, {{24, 24, 24}, {24, 24, 45}, {60, 24, 24}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<closest_point_on_triangle> hooks() {
    return {.map_centre = map_centre, .map_axes = map_axes, .laws = {.maps = Laws::Maps::axes}};
  }
};

}  // namespace touchstone::catalogue::rows
