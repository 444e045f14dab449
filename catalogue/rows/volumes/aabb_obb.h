// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/box_draws.h"
#include "catalogue/families/obb_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/volumes/aabb_obb.h"
#include "oracle/volumes/aabb_obb.h"
#include "reference/volumes/aabb_obb.h"
#include "robust/volumes/aabb_obb.h"

namespace touchstone::catalogue::rows {

struct aabb_obb : signatures::aabb_obb {
  TOUCHSTONE_STAGED_MODULES(aabb_obb)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "volumes",
      .pages = "27, 45-47",
      .question = "Do an axis-aligned and an oriented box overlap, only touch, or neither?",
      .kind = Kind::decision,
      .fields = {"aabb", "obb"},
      .answer = "contact",
      .margin_degree = 2,
      .cost = 10};

  static void hard_cases(HardCases<Question>& add) {
    add("touching", [](DrawStream& c) -> Question { return touching(c, lattice_half_axes); });
    add("near_touch", [](DrawStream& c) -> Question {
      Question q = touching(c, [](DrawStream& d) { return skew_half_axes(d, 20); });
      Point3d& center = std::get<1>(q).center;
      center = beside(center, c);
      return q;
    });
    add("crossing_edges", [](DrawStream& c) -> Question {
      // Boxes that only an axis of two edges separates, or none.
      const std::size_t i = c.below(3), j = 3 + c.below(3);
      const Obb3d a = straight(c);
      Question q = brought_to_touch(c, a, turned_half_axes(c), i, j);
      std::get<1>(q).center.x += small_integer(c, 1);
      return q;
    });
    add("parallel", [](DrawStream& c) -> Question {
      // Two boxes along the axes: side by side, nested, the same box.
      const Obb3d a = straight(c);
      return {corners(a), alike(a, c)};
    });
    add("flat", [](DrawStream& c) -> Question {
      // A rectangle, a segment or a point, that touches or reaches in.
      Question q = touching(c, lattice_half_axes);
      auto& [box, other] = q;
      flatten(box, c);
      if (c.coin()) other.center = box.min + small_integer(c, 2) / 2 * other.half_axes.v;
      return q;
    });
    add("nearly_flat", [](DrawStream& c) -> Question {
      Question q = touching(c, lattice_half_axes);
      Aabb3d& box = std::get<0>(q);
      box.max.x = moved_by_ulps(box.min.x, integer_in(c, 0, 2));
      return q;
    });
    add("center_between_doubles", [](DrawStream& c) -> Question {
      // Neither the center of the box nor half of its width is a double.
      Question q = touching(c, turned_half_axes);
      auto& [box, other] = q;
      const double far = power_of_two(c, 50, 56), off = small_integer(c, 1);
      if (c.coin()) box.min.x -= far + off;
      else box.max.x += far + off;
      return q;
    });
    add("nearly_dependent", [](DrawStream& c) -> Question {
      Question q = touching(c, slanted_half_axes);
      Point3d& center = std::get<1>(q).center;
      center = beside(center, c);
      return q;
    });
    add("dependent", [](DrawStream& c) -> Question {
      const Vector3d u = lattice_normal(c), v = lattice_normal(c);
      const double r = small_integer(c), s = small_integer(c);
      return {lattice_box(c), {lattice_point_in_space(c, 20), {u, r * u + s * v, v}}};
    });
    add("stretched", [](DrawStream& c) -> Question {
      Question q = touching(c, lattice_half_axes);
      Stretch{c, {0, 60, 255, -170, 300, -300, -355}}(std::get<0>(q), std::get<1>(q));
      return q;
    });
    add("long_and_thin", [](DrawStream& c) -> Question {
      const Obb3d box = long_and_thin_obb(c);
      const Point3d p = on_obb(box, c);
      Aabb3d other{p, p};
      (c.coin() ? other.max : other.min).x = small_integer(c);
      put_in_order(other);
      return {other, box};
    });
    add("rounded_touch", [](DrawStream& c) -> Question {
      return touching(c, ordinary_half_axes, [](DrawStream& d) -> Obb3d {
        const Point3d center = ordinary_point_in_space(d);
        return {center, {{ordinary(d), 0, 0}, {0, ordinary(d), 0}, {0, 0, ordinary(d)}}};
      });
    });
    add("terms_below_least", [](DrawStream& c) -> Question {
      // Products of three coordinates are a few times the least number, or less.
      Question q = touching(c, lattice_half_axes, [](DrawStream& d) -> Obb3d {
        return {{0, 0, 0}, straight_half_axes(d)};
      });
      const int k = -350 - integer_in(c, 0, 15);
      const auto change = [k](auto& v) { v = scaled(v, k); };
      change_each(std::get<0>(q), change), change_each(std::get<1>(q), change);
      return q;
    });
    add("moderate_ends", [](DrawStream& c) -> Question {
      // The greatest and the least numbers that the filter takes, and the next beyond them.
      const double large = power_of_two(c, 29, 31), least = power_of_two(c, -32, -29), off = small_integer(c, 1);
      return {{{-large, -1, -least}, {0, 1, least}},
              {{large + off * least, 0, 0}, {{large, 0, 0}, {0, 1, least}, {0, 0, 1}}}};
    });
    add("whole_range", [](DrawStream& c) -> Question {
      const double great = huge(c), far = c.coin() ? great : small_integer(c), x = small_integer(c, 1) * great;
      return {{{-great, -great, -1}, {c.coin() ? great : 0, great, 1}},
              {{great, far, 0}, {{great, x, 0}, {0, great, 0}, {far, 0, 1}}}};
    });
    add("either_zero", [](DrawStream& c) -> Question {
      const double x = small_integer(c, 2), y = small_integer(c, 2), low = zero(c), high = zero(c);
      return {
          {{low, -1, -1}, {c.coin() ? 1 : high, zero(c), 1}},
          {{x == 0 ? zero(c) : x, y, zero(c)}, {{zero(c), 1, zero(c)}, {1, zero(c), zero(c)}, {zero(c), zero(c), 1}}}};
    });
    add("typed_touch", [](DrawStream& c) -> Question {
      // As typed a corner of a box that is turned by the triple 3, 4, 5 is on a face.
      const double k = one_to(c, 9), m = one_to(c, 9);
      return {{{-1, m / 10, -1}, {1, (m + 3) / 10, 1}},
              {{0, (m - 4 * k - 6) / 10, 0}, {{3 * k / 10, 4 * k / 10, 0}, {-0.8, 0.6, 0}, {0, 0, 1}}}};
    });
  }

  static void repair(Question& q) { put_in_order(std::get<0>(q)); }

  /// A corner of a rotated box on a side of a straight one.
  static Question map_centre() { return {{{-4, -4, -1}, {4, 4, 1}}, {{11, 1, 0}, {{3, 4, 0}, {-4, 3, 0}, {0, 0, 1}}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {6, 7}; }

  static Hooks<aabb_obb> hooks() {
    return {.as_open_sets = disjoint_if_touching<Question>,
            .repair = repair,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }

 private:
  static Obb3d straight(DrawStream& c) {
    const HalfAxes3d h = straight_half_axes(c);
    return {lattice_point_in_space(c, 20), h};
  }
  static Aabb3d corners(const Obb3d& box) {
    const auto& [u, v, w] = box.half_axes;
    const Point3d& c = box.center;
    const double x = std::fabs(u.x + v.x + w.x), y = std::fabs(u.y + v.y + w.y), z = std::fabs(u.z + v.z + w.z);
    return {{c.x - x, c.y - y, c.z - z}, {c.x + x, c.y + y, c.z + z}};
  }
  static Question brought_to_touch(DrawStream& c, const Obb3d& a, const HalfAxes3d& half_axes, std::size_t i,
                                   std::size_t j) {
    Obb3d b{{}, half_axes};
    bring_to_touch(a, b, i, j, c);
    return {corners(a), b};
  }
  static Question touching(DrawStream& c, HalfAxes3d (*half_axes)(DrawStream&),
                           Obb3d (*aligned)(DrawStream&) = straight) {
    const std::size_t i = c.below(6), j = c.below(5);
    const Obb3d a = aligned(c);
    return brought_to_touch(c, a, half_axes(c), i, j < i ? j : j + 1);
  }
};

}  // namespace touchstone::catalogue::rows
