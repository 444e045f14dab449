// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/closest_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/sphere_capsule.h"
#include "oracle/mixed/sphere_capsule.h"
#include "reference/mixed/sphere_capsule.h"
#include "reference/standard/point_and_segment.h"
#include "robust/mixed/sphere_capsule.h"

namespace touchstone::catalogue::rows {

struct sphere_capsule : signatures::sphere_capsule {
  TOUCHSTONE_STAGED_MODULES(sphere_capsule)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "mixed",
                                     .pages = "9, 44",
                                     .question = "Do a ball and a capsule overlap, only touch, or neither?",
                                     .kind = Kind::decision,
                                     .fields = {"sphere", "capsule"},
                                     .answer = "contact",
                                     .margin_degree = 2,
                                     .cost = 4,
                                     .longest_vector = 2300};

  static void standard(const auto& add) {
    add("Ericson, closest point of a segment",
        [](const auto&... q) { return ::touchstone::reference::standard::sphere_capsule_by_nearest_point(q...); });
    add("Ericson, squared distance from a segment",
        [](const auto&... q) { return ::touchstone::reference::standard::sphere_capsule_by_squares(q...); });
  }

  static void hard_cases(HardCases<Question>& add) {
    add("tangent_beside", [](DrawStream& c) -> Question {
      const IntegerAcross across = IntegerAcross::of(c);
      const LatticePlane line{lattice_point_in_space(c, 16), across.u, across.displacement};
      const auto [r, s] = reaching_radii(c, across.length);
      const double i = small_integer(c, 3), j = small_integer(c, 3);
      return {{line.at(small_integer(c, 3), 1), r}, {{line.at(i, 0), line.at(j, 0)}, s}};
    });
    add("tangent_to_end", [](DrawStream& c) -> Question {
      const Step step = integer_step(c);
      const Point3d end = lattice_point_in_space(c, 16);
      const auto [r, s] = reaching_radii(c, step.length);
      const double back = -up_to(c, 2);
      return {{end + step.displacement, r},
              {{along(end, back, step.displacement) + lattice_across(c, step.displacement), end}, s}};
    });
    add("center_on_segment_or_line", [](DrawStream& c) -> Question {
      const LatticePlane line = LatticePlane::of(c, 8);
      const double i = small_integer(c, 3), j = small_integer(c, 3), k = small_integer(c, 3);
      const double r = up_to(c, 2), s = up_to(c, 2);
      return {{line.at(k, 0), r}, {{line.at(i, 0), line.at(j, 0)}, s}};
    });
    add("no_radius", [](DrawStream& c) -> Question {
      // A point, a segment, or both, deep in the other solid or outside of it.
      const LatticePlane line = LatticePlane::of(c, 4);
      const double none = zero(c), other = up_to(c, 63);
      const bool both = c.one_in(4), point = c.coin();
      const double i = small_integer(c, 3), j = small_integer(c, 3);
      return {{line.point(c, 2), point || both ? none : other},
              {{line.at(i, 0), line.at(j, 0)}, point && !both ? other : none}};
    });
    add("zero_length", [](DrawStream& c) -> Question {
      const Step step = integer_step(c);
      const Point3d p = lattice_point_in_space(c, 16);
      const auto [r, s] = reaching_radii(c, step.length);
      return {{p + step.displacement, r}, {{p, p}, s}};
    });
    add("near_root", [](DrawStream& c) -> Question {
      const auto [x, r] = near_root(c);
      const double part = std::floor(x * up_to(c, 4) / 4);
      return {{{r, r, integer(c, 10)}, x - part}, {{{0, 0, -4096}, {0, 0, 4096}}, part}};
    });
    add("rounded_tangent", [](DrawStream& c) -> Question {
      const Point3d p = ordinary_point_in_space(c), a = ordinary_point_in_space(c);
      const Vector3d displacement = p - a;
      const double part = c.coin() ? 0.0 : std::fabs(ordinary(c)) * 0.25;
      return {{p, std::fabs(near_length(c, displacement) - part)}, {{a, along(a, -1, displacement)}, part}};
    });
    add("needle", [](DrawStream& c) -> Question {
      const IntegerAcross across = IntegerAcross::of(c);
      const Point3d p = lattice_point_in_space(c, 12);
      const double length = scaled_up(c, 8, 24), other = scaled_up(c, 8, 24);
      const auto [r, s] = reaching_radii(c, across.length);
      return {{p + across.displacement, r}, {{along(p, -length, across.u), along(p, other, across.u)}, s}};
    });
    add("sum_of_radii_rounds", [](DrawStream& c) -> Question {
      // The sum has digits that no double has; so has the distance, or not.
      const double r = 0x1p53 + 2 * static_cast<double>(c.below(1 << 20)), s = up_to(c, 3);
      const double off = small_integer(c, 1), far = up_to(c, 8);
      return {{{r, 0, far}, r}, {{{-s, 0, -8}, {-s, off, 8}}, s}};
    });
    add("off_by_a_hair", [](DrawStream& c) -> Question {
      const double r = scaled_up(c, 4, 1000), most = scaled_up(c, 4, 1000), s = c.coin() ? r : 0.0;
      return {{{0, c.coin() ? -r - s : r + s, 0}, r}, {{{-most, hair(c), 0}, {most, 0, 0}}, s}};
    });
    add("stretched", [](DrawStream& c) -> Question {
      const LatticePlane plane = LatticePlane::of(c);
      Point3d p = plane.point(c), a = plane.point(c), b = plane.point(c);
      Stretch{c}(p, a, b);
      return {{p, scaled_down(c, 4, 300)}, {{a, b}, scaled_down(c, 4, 300)}};
    });
    add("typed_shapes", [](DrawStream& c) -> Question {
      const Point3d p = typed_point(c), a = typed_point(c);
      return {{p, std::fabs(typed(c))}, {{a, {p.x, p.y + 0.5, p.z}}, std::fabs(typed(c))}};
    });
    add("subnormal", [](DrawStream& c) -> Question {
      const Point3d p = subnormal_point(c), a = subnormal_point(c);
      const double r = std::ldexp(up_to(c, 5), -1074), s = std::ldexp(up_to(c, 5), -1074);
      return {{p, r}, {{a, c.coin() ? lattice_point_in_space(c, 4) : subnormal_point(c)}, s}};
    });
    add("whole_range", [](DrawStream& c) -> Question {
      const Point3d p = point_of_full_range(c), a = point_of_full_range(c), b = point_of_full_range(c);
      return {{p, std::fabs(of_full_range(c))}, {{a, b}, std::fabs(of_full_range(c))}};
    });
    add("either_zero", [](DrawStream& c) -> Question {
      const Point3d p = zero_point(c), a = zero_point(c), b = zero_point(c);
      const double r = c.coin() ? -0.0 : up_to(c, 1), s = c.coin() ? -0.0 : 1;
      return {{p, r}, {{a, c.coin() ? b : Point3d{1, b.y, b.z}}, s}};
    });
    add.unscaled("negative_radius", [](DrawStream& c) -> Question {
      // In one of the two solids or in both, which a filter would separate.
      const Point3d p = lattice_point_in_space(c, 16), a = lattice_point_in_space(c, 16);
      const double r = one_to(c, 8), s = one_to(c, 8);
      const std::uint64_t which = c.below(3);
      return {{p, which > 0 ? -r : r}, {{a, lattice_point_in_space(c, 16)}, which == 1 ? s : -s}};
    });
  }

  /// A ball that reaches the capsule's end by the triple 3, 4, 5; moves its center.
  static Question map_centre() { return {{{21, 20, 24}, 3}, {{{24, 24, 24}, {48, 36, 24}}, 2}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<sphere_capsule> hooks() { return hooks_of_round_pair<sphere_capsule>(); }
};

}  // namespace touchstone::catalogue::rows
