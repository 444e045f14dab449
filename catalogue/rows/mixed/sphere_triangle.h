// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/closest_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "oracle/mixed/sphere_triangle.h"
#include "reference/mixed/sphere_triangle.h"
#include "reference/standard/point_and_triangle.h"
#include "robust/mixed/sphere_triangle.h"

namespace touchstone::catalogue::rows {

struct sphere_triangle {
  TOUCHSTONE_MODULES(sphere_triangle)
  using stages = ::touchstone::robust::stages::sphere_triangle;
  using Question = std::tuple<Sphere3d, Triangle3d>;
  using decision = NoDecision;

  static const Metadata& metadata() {
    static const Metadata metadata{.name = "sphere_triangle",
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

  static std::vector<HardCase<Question>> hard_cases() {
    return {
        {"tangent_to_face",
         [](DrawStream& c) -> Question {
           const WholeAcross across = WholeAcross::of(c);
           const LatticePlane plane{lattice_point_in_space(c, 16), across.u, across.v};
           const Triangle3d t = plane.triangle(c);
           return {{plane.point(c) + across.way, reaching(c, across.length)}, t};
         }},
        {"tangent_to_edge",
         [](DrawStream& c) -> Question {
           const WholeAcross across = WholeAcross::of(c);
           const LatticePlane edge{lattice_point_in_space(c, 16), across.u, across.way};
           const double i = small_integer(c, 3), j = small_integer(c, 3), back = -static_cast<double>(c.below(4));
           const Triangle3d t{edge.at(i, 0), edge.at(j, 0), edge.at(small_integer(c, 3), back) + across.v};
           return {{edge.at(small_integer(c, 3), 1), reaching(c, across.length)}, t};
         }},
        {"tangent_to_corner",
         [](DrawStream& c) -> Question {
           const Step step = whole_step(c);
           const Point3d corner = lattice_point_in_space(c, 16);
           const auto back = [&] {
             const double i = -static_cast<double>(c.below(3));
             return along(corner, i, step.way) + lattice_across(c, step.way);
           };
           const Point3d a = back(), b = back();
           return {{corner + step.way, reaching(c, step.length)}, {a, b, corner}};
         }},
        {"center_in_plane_or_triangle",
         [](DrawStream& c) -> Question {
           const LatticePlane plane = LatticePlane::of(c, 6);
           const Triangle3d t = plane.triangle(c);
           const double r = static_cast<double>(c.below(3));
           return {{plane.point(c), r}, t};
         }},
        {"point_ball",
         [](DrawStream& c) -> Question {
           const LatticePlane plane = LatticePlane::of(c, 6);
           const Triangle3d t = plane.triangle(c);
           return {{plane.point(c), c.below(2) == 1 ? -0.0 : 0.0}, t};
         }},
        {"no_area",
         [](DrawStream& c) -> Question {
           const WholeAcross across = WholeAcross::of(c);
           const LatticePlane line{lattice_point_in_space(c, 16), across.u, across.way};
           const double i = small_integer(c, 3), j = small_integer(c, 3), k = small_integer(c, 3);
           return {{line.at(small_integer(c, 3), 1), reaching(c, across.length)},
                   {line.at(i, 0), line.at(j, 0), line.at(k, 0)}};
         }},
        {"triangle_is_point",
         [](DrawStream& c) -> Question {
           const Step step = whole_step(c);
           const Point3d p = lattice_point_in_space(c, 16);
           return {{p + step.way, reaching(c, step.length)}, {p, p, p}};
         }},
        {"near_root",
         [](DrawStream& c) -> Question {
           const auto [x, r] = near_root(c);
           const double far = 1 + static_cast<double>(c.below(8));
           return {{{r, r, integer(c, 10)}, x}, {{0, 0, -4096}, {0, 0, 4096}, {-far, 0, 0}}};
         }},
        {"rounded_tangent",
         [](DrawStream& c) -> Question {
           const Point3d p = ordinary_point_in_space(c), a = ordinary_point_in_space(c);
           const Vector3d way = p - a;
           return {{p, near_length(c, way)}, {a, along(a, -1, way), a + lattice_across(c, {1, 0, 0})}};
         }},
        {"needle",
         [](DrawStream& c) -> Question {
           const double length = std::ldexp(1, 20 + static_cast<int>(c.below(22)));
           const double y = small_integer(c, 3), z = small_integer(c, 3);
           const Triangle3d t{{-length, y, z}, {length, small_integer(c, 3), 0}, {length, 0, small_integer(c, 3)}};
           const Point3d p = lattice_point_in_space(c, 4);
           return {{p, reaching(c, std::fabs(p.y))}, t};
         }},
        {"off_by_a_hair",
         [](DrawStream& c) -> Question {
           const double r = scaled_up(c, 4, 1000), most = scaled_up(c, 4, 1000);
           return {{{0, c.below(2) == 1 ? -r : r, 0}, r}, {{-most, hair(c), -most}, {most, 0, -most}, {0, 0, most}}};
         }},
        {"stretched",
         [](DrawStream& c) -> Question {
           const LatticePlane plane = LatticePlane::of(c);
           Triangle3d t = plane.triangle(c);
           Point3d p = plane.point(c);
           stretch(c, p, t.a, t.b, t.c);
           return {{p, scaled_down(c, 4, 300)}, t};
         }},
        {"typed",
         [](DrawStream& c) -> Question {
           const Point3d p = typed_point(c), a = typed_point(c), b = typed_point(c);
           return {{p, std::fabs(typed(c))}, {a, b, {p.x, p.y + 0.5, p.z}}};
         }},
        {"subnormal",
         [](DrawStream& c) -> Question {
           const Point3d p = subnormal_point(c), a = subnormal_point(c), b = subnormal_point(c);
           const double r = std::ldexp(static_cast<double>(c.below(6)), -1074);
           return {{p, r}, {a, b, c.below(2) == 1 ? lattice_point_in_space(c, 4) : subnormal_point(c)}};
         }},
        {"whole_range",
         [](DrawStream& c) -> Question {
           const Point3d p = point_of_whole_range(c), a = point_of_whole_range(c), b = point_of_whole_range(c);
           return {{p, std::fabs(of_whole_range(c))}, {a, b, point_of_whole_range(c)}};
         }},
        {"either_zero",
         [](DrawStream& c) -> Question {
           const Point3d p = zero_point(c), a = zero_point(c), b = zero_point(c), d = zero_point(c);
           const double r = c.below(2) == 1 ? -0.0 : static_cast<double>(c.below(2));
           return {{p, r}, {a, c.below(2) == 1 ? b : Point3d{1, b.y, b.z}, d}};
         }},
    };
  }

  /// What would make a radius negative is taken without its sign.
  static void repair(Question& q) { std::get<0>(q).radius = std::fabs(std::get<0>(q).radius); }

  /// A ball that reaches the corner (24, 24, 24) by the triple 3, 4, 5; moves its center.
  static Question map_centre() { return {{{21, 20, 24}, 5}, {{24, 24, 24}, {48, 24, 30}, {30, 48, 24}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<sphere_triangle> hooks() {
    return {.as_open_sets = disjoint_if_touching<Question>,
            .repair = repair,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::similarities, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
