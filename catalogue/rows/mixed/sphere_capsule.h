// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/closest_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "oracle/mixed/sphere_capsule.h"
#include "reference/mixed/sphere_capsule.h"
#include "reference/standard/point_and_segment.h"
#include "robust/mixed/sphere_capsule.h"

namespace touchstone::catalogue::rows {

struct sphere_capsule {
  TOUCHSTONE_MODULES(sphere_capsule)
  using stages = ::touchstone::robust::stages::sphere_capsule;
  using Question = std::tuple<Sphere3d, Capsule3d>;
  using decision = NoDecision;

  static const Metadata& metadata() {
    static const Metadata metadata{.name = "sphere_capsule",
                                   .chapter = "mixed",
                                   .pages = "9, 44",
                                   .question = "Do a ball and a capsule overlap, only touch, or neither?",
                                   .kind = Kind::decision,
                                   .fields = {"sphere", "capsule"},
                                   .answer = "contact",
                                   .margin_degree = 2,
                                   .cost = 4,
                                   .longest_vector = 2300};
    return metadata;
  }

  static void standard(const auto& add) {
    add("Ericson, closest point of a segment",
        [](const auto&... q) { return ::touchstone::reference::standard::sphere_capsule_by_nearest_point(q...); });
    add("Ericson, squared distance from a segment",
        [](const auto&... q) { return ::touchstone::reference::standard::sphere_capsule_by_squares(q...); });
  }

  static std::vector<HardCase<Question>> hard_cases() {
    return {
        {"tangent_beside",
         [](DrawStream& c) -> Question {
           const WholeAcross across = WholeAcross::of(c);
           const LatticePlane line{lattice_point_in_space(c, 16), across.u, across.way};
           const auto [r, s] = reaching_radii(c, across.length);
           const double i = small_integer(c, 3), j = small_integer(c, 3);
           return {{line.at(small_integer(c, 3), 1), r}, {{line.at(i, 0), line.at(j, 0)}, s}};
         }},
        {"tangent_to_end",
         [](DrawStream& c) -> Question {
           const Step step = whole_step(c);
           const Point3d end = lattice_point_in_space(c, 16);
           const auto [r, s] = reaching_radii(c, step.length);
           const double back = -static_cast<double>(c.below(3));
           return {{end + step.way, r}, {{along(end, back, step.way) + lattice_across(c, step.way), end}, s}};
         }},
        {"center_on_segment_or_line",
         [](DrawStream& c) -> Question {
           const LatticePlane line = LatticePlane::of(c, 8);
           const double i = small_integer(c, 3), j = small_integer(c, 3), k = small_integer(c, 3);
           const double r = static_cast<double>(c.below(3)), s = static_cast<double>(c.below(3));
           return {{line.at(k, 0), r}, {{line.at(i, 0), line.at(j, 0)}, s}};
         }},
        {"no_radius",
         [](DrawStream& c) -> Question {
           // A point, a segment, or both, deep in the other solid or beside it.
           const LatticePlane line = LatticePlane::of(c, 4);
           const double zero = c.below(2) == 1 ? -0.0 : 0.0, other = static_cast<double>(c.below(64));
           const bool both = c.below(4) == 3, point = c.below(2) == 1;
           const double i = small_integer(c, 3), j = small_integer(c, 3);
           return {{line.point(c, 2), point || both ? zero : other},
                   {{line.at(i, 0), line.at(j, 0)}, point && !both ? other : zero}};
         }},
        {"zero_length",
         [](DrawStream& c) -> Question {
           const Step step = whole_step(c);
           const Point3d p = lattice_point_in_space(c, 16);
           const auto [r, s] = reaching_radii(c, step.length);
           return {{p + step.way, r}, {{p, p}, s}};
         }},
        {"near_root",
         [](DrawStream& c) -> Question {
           const auto [x, r] = near_root(c);
           const double part = std::floor(x * static_cast<double>(c.below(5)) / 4);
           return {{{r, r, integer(c, 10)}, x - part}, {{{0, 0, -4096}, {0, 0, 4096}}, part}};
         }},
        {"rounded_tangent",
         [](DrawStream& c) -> Question {
           const Point3d p = ordinary_point_in_space(c), a = ordinary_point_in_space(c);
           const Vector3d way = p - a;
           const double part = c.below(2) == 1 ? 0.0 : std::fabs(ordinary(c)) * 0.25;
           return {{p, std::fabs(near_length(c, way) - part)}, {{a, along(a, -1, way)}, part}};
         }},
        {"needle",
         [](DrawStream& c) -> Question {
           const WholeAcross across = WholeAcross::of(c);
           const Point3d p = lattice_point_in_space(c, 12);
           const double length = scaled_up(c, 8, 24), other = scaled_up(c, 8, 24);
           const auto [r, s] = reaching_radii(c, across.length);
           return {{p + across.way, r}, {{along(p, -length, across.u), along(p, other, across.u)}, s}};
         }},
        {"sum_of_radii_rounds",
         [](DrawStream& c) -> Question {
           // The sum has digits that no double has; so has the distance, or not.
           const double r = 0x1p53 + 2 * static_cast<double>(c.below(1 << 20)), s = static_cast<double>(c.below(4));
           const double off = small_integer(c, 1), far = static_cast<double>(c.below(9));
           return {{{r, 0, far}, r}, {{{-s, 0, -8}, {-s, off, 8}}, s}};
         }},
        {"off_by_a_hair",
         [](DrawStream& c) -> Question {
           const double r = scaled_up(c, 4, 1000), most = scaled_up(c, 4, 1000), s = c.below(2) == 1 ? r : 0.0;
           return {{{0, c.below(2) == 1 ? -r - s : r + s, 0}, r}, {{{-most, hair(c), 0}, {most, 0, 0}}, s}};
         }},
        {"stretched",
         [](DrawStream& c) -> Question {
           const LatticePlane plane = LatticePlane::of(c);
           Point3d p = plane.point(c), a = plane.point(c), b = plane.point(c);
           stretch(c, p, a, b);
           const double r = scaled_down(c, 4, 300);
           return {{p, r}, {{a, b}, scaled_down(c, 4, 300)}};
         }},
        {"typed",
         [](DrawStream& c) -> Question {
           const Point3d p = typed_point(c), a = typed_point(c);
           const double r = std::fabs(typed(c));
           return {{p, r}, {{a, {p.x, p.y + 0.5, p.z}}, std::fabs(typed(c))}};
         }},
        {"subnormal",
         [](DrawStream& c) -> Question {
           const Point3d p = subnormal_point(c), a = subnormal_point(c);
           const double r = std::ldexp(static_cast<double>(c.below(6)), -1074),
                        s = std::ldexp(static_cast<double>(c.below(6)), -1074);
           return {{p, r}, {{a, c.below(2) == 1 ? lattice_point_in_space(c, 4) : subnormal_point(c)}, s}};
         }},
        {"whole_range",
         [](DrawStream& c) -> Question {
           const Point3d p = point_of_whole_range(c), a = point_of_whole_range(c), b = point_of_whole_range(c);
           const double r = std::fabs(of_whole_range(c));
           return {{p, r}, {{a, b}, std::fabs(of_whole_range(c))}};
         }},
        {"either_zero",
         [](DrawStream& c) -> Question {
           const Point3d p = zero_point(c), a = zero_point(c), b = zero_point(c);
           const double r = c.below(2) == 1 ? -0.0 : static_cast<double>(c.below(2)), s = c.below(2) == 1 ? -0.0 : 1;
           return {{p, r}, {{a, c.below(2) == 1 ? b : Point3d{1, b.y, b.z}}, s}};
         }},
        {"negative_radius",
         [](DrawStream& c) -> Question {
           // Of one of the two or of both, of solids that a filter would part.
           const Point3d p = lattice_point_in_space(c, 16), a = lattice_point_in_space(c, 16);
           const double r = 1 + static_cast<double>(c.below(8)), s = 1 + static_cast<double>(c.below(8));
           const std::uint64_t which = c.below(3);
           return {{p, which > 0 ? -r : r}, {{a, lattice_point_in_space(c, 16)}, which == 1 ? s : -s}};
         },
         /*unscaled=*/true},
    };
  }

  /// What would make a radius negative is taken without its sign.
  static void repair(Question& q) {
    std::get<0>(q).radius = std::fabs(std::get<0>(q).radius);
    std::get<1>(q).radius = std::fabs(std::get<1>(q).radius);
  }

  /// A ball that reaches the capsule's end by the triple 3, 4, 5; moves its center.
  static Question map_centre() { return {{{21, 20, 24}, 3}, {{{24, 24, 24}, {48, 36, 24}}, 2}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<sphere_capsule> hooks() {
    return {.as_open_sets = disjoint_if_touching<Question>,
            .repair = repair,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::similarities, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
