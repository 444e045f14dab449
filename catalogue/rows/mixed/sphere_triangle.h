// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/closest_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/sphere_triangle.h"
#include "oracle/mixed/sphere_triangle.h"
#include "reference/mixed/sphere_triangle.h"
#include "reference/standard/point_and_triangle.h"
#include "robust/mixed/sphere_triangle.h"

namespace touchstone::catalogue::rows {

struct sphere_triangle : signatures::sphere_triangle {
  TOUCHSTONE_MODULES(sphere_triangle)
  using stages = ::touchstone::robust::stages::sphere_triangle;
  using decision = NoDecision;

  static const Metadata& metadata() {
    static const Metadata metadata{.name = name,
                                   .chapter = "mixed",
                                   .pages = "9, 48-50, 54",
                                   .question = "Do a ball and a triangle overlap, only touch, or neither?",
                                   .kind = Kind::decision,
                                   .fields = {"sphere", "triangle"},
                                   .answer = "contact",
                                   .margin_degree = 2,
                                   .cost = 10,
                                   .longest_vector = 2300};
    return metadata;
  }

  static void standard(const auto& add) {
    add("foot on the plane, else the nearest edge", [](const auto&... q) {
      return ::touchstone::reference::standard::sphere_triangle<::touchstone::reference::standard::ByFaceOrEdges>(q...);
    });
    add("Ericson, closest point of a triangle, times a reciprocal", [](const auto&... q) {
      return ::touchstone::reference::standard::sphere_triangle<::touchstone::reference::standard::ByRegions>(q...);
    });
  }

  static void hard_cases(HardCases<Question>& add) {
    add("tangent_to_face", [](DrawStream& c) -> Question {
      const IntegerAcross across = IntegerAcross::of(c);
      const LatticePlane plane{lattice_point_in_space(c, 16), across.u, across.v};
      const Triangle3d t = plane.triangle(c);
      return {{plane.point(c) + across.displacement, reaching(c, across.length)}, t};
    });
    add("tangent_to_edge", [](DrawStream& c) -> Question {
      const IntegerAcross across = IntegerAcross::of(c);
      const LatticePlane edge{lattice_point_in_space(c, 16), across.u, across.displacement};
      const double i = small_integer(c, 3), j = small_integer(c, 3), back = -up_to(c, 3);
      const Triangle3d t{edge.at(i, 0), edge.at(j, 0), edge.at(small_integer(c, 3), back) + across.v};
      return {{edge.at(small_integer(c, 3), 1), reaching(c, across.length)}, t};
    });
    add("tangent_to_corner", [](DrawStream& c) -> Question {
      const Step step = integer_step(c);
      const Point3d corner = lattice_point_in_space(c, 16);
      const auto back = [&] {
        const double i = -up_to(c, 2);
        return along(corner, i, step.displacement) + lattice_across(c, step.displacement);
      };
      const Point3d a = back(), b = back();
      return {{corner + step.displacement, reaching(c, step.length)}, {a, b, corner}};
    });
    add("center_in_plane_or_triangle", [](DrawStream& c) -> Question {
      const LatticePlane plane = LatticePlane::of(c, 6);
      const Triangle3d t = plane.triangle(c);
      const double r = up_to(c, 2);
      return {{plane.point(c), r}, t};
    });
    add("point_ball", [](DrawStream& c) -> Question {
      const LatticePlane plane = LatticePlane::of(c, 6);
      const Triangle3d t = plane.triangle(c);
      return {{plane.point(c), zero(c)}, t};
    });
    add("no_area", [](DrawStream& c) -> Question {
      const IntegerAcross across = IntegerAcross::of(c);
      const LatticePlane line{lattice_point_in_space(c, 16), across.u, across.displacement};
      const double i = small_integer(c, 3), j = small_integer(c, 3), k = small_integer(c, 3);
      return {{line.at(small_integer(c, 3), 1), reaching(c, across.length)},
              {line.at(i, 0), line.at(j, 0), line.at(k, 0)}};
    });
    add("triangle_is_point", [](DrawStream& c) -> Question {
      const Step step = integer_step(c);
      const Point3d p = lattice_point_in_space(c, 16);
      return {{p + step.displacement, reaching(c, step.length)}, {p, p, p}};
    });
    add("near_root", [](DrawStream& c) -> Question {
      const auto [x, r] = near_root(c);
      const double far = one_to(c, 8);
      return {{{r, r, integer(c, 10)}, x}, {{0, 0, -4096}, {0, 0, 4096}, {-far, 0, 0}}};
    });
    add("rounded_tangent", [](DrawStream& c) -> Question {
      const Point3d p = ordinary_point_in_space(c), a = ordinary_point_in_space(c);
      const Vector3d displacement = p - a;
      return {{p, near_length(c, displacement)}, {a, along(a, -1, displacement), a + lattice_across(c, {1, 0, 0})}};
    });
    add("needle", [](DrawStream& c) -> Question {
      const double length = power_of_two(c, 20, 41), y = small_integer(c, 3), z = small_integer(c, 3);
      const Triangle3d t{{-length, y, z}, {length, small_integer(c, 3), 0}, {length, 0, small_integer(c, 3)}};
      const Point3d p = lattice_point_in_space(c, 4);
      return {{p, reaching(c, std::fabs(p.y))}, t};
    });
    add("off_by_a_hair", [](DrawStream& c) -> Question {
      const double r = scaled_up(c, 4, 1000), most = scaled_up(c, 4, 1000);
      return {{{0, either_sign(c) * r, 0}, r}, {{-most, hair(c), -most}, {most, 0, -most}, {0, 0, most}}};
    });
    add("stretched", [](DrawStream& c) -> Question {
      const LatticePlane plane = LatticePlane::of(c);
      Triangle3d t = plane.triangle(c);
      Point3d p = plane.point(c);
      Stretch{c}(p, t);
      return {{p, scaled_down(c, 4, 300)}, t};
    });
    add("typed_shapes", [](DrawStream& c) -> Question {
      const Point3d p = typed_point(c), a = typed_point(c), b = typed_point(c);
      return {{p, std::fabs(typed(c))}, {a, b, {p.x, p.y + 0.5, p.z}}};
    });
    add("subnormal", [](DrawStream& c) -> Question {
      const Point3d p = subnormal_point(c), a = subnormal_point(c), b = subnormal_point(c);
      const double r = std::ldexp(up_to(c, 5), -1074);
      return {{p, r}, {a, b, c.coin() ? lattice_point_in_space(c, 4) : subnormal_point(c)}};
    });
    add("whole_range", [](DrawStream& c) -> Question {
      const Point3d p = point_of_full_range(c), a = point_of_full_range(c), b = point_of_full_range(c);
      return {{p, std::fabs(of_full_range(c))}, {a, b, point_of_full_range(c)}};
    });
    add("either_zero", [](DrawStream& c) -> Question {
      const Point3d p = zero_point(c), a = zero_point(c), b = zero_point(c), d = zero_point(c);
      const double r = c.coin() ? -0.0 : up_to(c, 1);
      return {{p, r}, {a, c.coin() ? b : Point3d{1, b.y, b.z}, d}};
    });
  }

  /// A ball that reaches the corner (24, 24, 24) by the triple 3, 4, 5; moves its center.
  static Question map_centre() { return {{{21, 20, 24}, 5}, {{24, 24, 24}, {48, 24, 30}, {30, 48, 24}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<sphere_triangle> hooks() { return hooks_of_round_pair<sphere_triangle>(); }
};

}  // namespace touchstone::catalogue::rows
