// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/obb_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/volumes/point_in_obb.h"
#include "oracle/volumes/point_in_obb.h"
#include "reference/standard/oriented_boxes.h"
#include "reference/volumes/point_in_obb.h"
#include "robust/volumes/point_in_obb.h"

namespace touchstone::catalogue::rows {

struct point_in_obb : signatures::point_in_obb {
  TOUCHSTONE_STAGED_MODULES(point_in_obb)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "volumes",
      .pages = "27",
      .question = "Does the point lie inside the oriented box, on its boundary, or outside?",
      .kind = Kind::decision,
      .fields = {"obb", "point"},
      .answer = "location",
      .margin_degree = 2,
      .cost = 2};

  static void standard(const auto& add) {
    add("unit axes and half lengths",
        [](const auto&... q) { return ::touchstone::reference::standard::point_in_obb(q...); });
  }

  static void hard_cases(HardCases<Question>& add) {
    add("on_boundary", [](DrawStream& c) -> Question {
      const Obb3d box = lattice_obb(c);
      return {box, on_obb(box, c)};
    });
    add("on_orthogonal_box", [](DrawStream& c) -> Question {
      const Obb3d box{lattice_point_in_space(c, 20), c.coin() ? turned_half_axes(c) : straight_half_axes(c)};
      return {box, on_obb(box, c)};
    });
    add("around", [](DrawStream& c) -> Question {
      const Obb3d box = lattice_obb(c);
      const double r = small_integer(c, 3), s = small_integer(c, 3);
      return {box, halves_along(box, r, s, small_integer(c, 3))};
    });
    add("near_boundary", [](DrawStream& c) -> Question {
      const Obb3d box{lattice_point_in_space(c, 20), skew_half_axes(c, 24)};
      return {box, beside(on_obb(box, c), c)};
    });
    add("nearly_dependent", [](DrawStream& c) -> Question {
      const Obb3d box{lattice_point_in_space(c, 20), slanted_half_axes(c)};
      return {box, beside(on_obb(box, c), c)};
    });
    add("dependent", [](DrawStream& c) -> Question {
      const Vector3d u = lattice_normal(c), v = lattice_normal(c);
      const double r = small_integer(c), s = small_integer(c);
      const Vector3d w = r * u + s * v;
      const Obb3d box{lattice_point_in_space(c, 20), c.coin() ? HalfAxes3d{w, u, v} : HalfAxes3d{u, v, w}};
      return {box, lattice_point_in_space(c, 20)};
    });
    add("stretched", [](DrawStream& c) -> Question {
      Obb3d box = lattice_obb(c);
      Point3d p = on_obb(box, c);
      Stretch{c, {0, 60, 255, -170, 300, -300, -355}}(box, p);
      return {box, p};
    });
    add("long_and_thin", [](DrawStream& c) -> Question {
      const Obb3d box = long_and_thin_obb(c);
      const double r = small_integer(c, 3);
      switch (c.below(3)) {
        case 0: return {box, halves_along(box, r, 0, 0)};
        case 1: return {box, halves_along(box, 0, r, 0)};
        default: return {box, halves_along(box, 0, 0, r)};
      }
    });
    add("rounded_on_face", [](DrawStream& c) -> Question {
      const HalfAxes3d axes = ordinary_half_axes(c);
      const Obb3d box{{ordinary(c), 0, 1}, axes};
      const double s = 2 * ordinary(c), t = 2 * ordinary(c);
      return {box, halves_along(box, 2, s, t)};
    });
    add("terms_below_least", [](DrawStream& c) -> Question {
      // Products of three coordinates are a few times the least number, or less.
      Obb3d box{{0, 0, 0}, lattice_half_axes(c)};
      Point3d p = on_obb(box, c);
      const int k = -350 - integer_in(c, 0, 15);
      change_each(box, [k](auto& v) { v = scaled(v, k); });
      return {box, scaled(p, k)};
    });
    add("whole_range", [](DrawStream& c) -> Question {
      // The point's way from the center is beyond the range.
      const auto part = [&c] { return std::ldexp(static_cast<double>(4 + c.below(4)), 1021); };
      const double x = part(), y = part(), r = part(), far = small_integer(c, 1);
      return {{{-x, 0, 0}, {{r, 0, 0}, {far * x, y, 0}, {0, 0, 1}}}, {r - x, far * r, small_integer(c, 1)}};
    });
    add("either_zero", [](DrawStream& c) -> Question {
      Obb3d box{{zero(c), zero(c), zero(c)}, {{1, zero(c), zero(c)}, {zero(c), -1, zero(c)}, {zero(c), zero(c), 1}}};
      const double x = small_integer(c, 1);
      return {box, {x == 0 ? zero(c) : x, zero(c), zero(c)}};
    });
    add("typed_boundary", [](DrawStream& c) -> Question {
      // As typed the point is on a face.
      const double k = one_to(c, 9), m = one_to(c, 9);
      return {{{k / 10, 0, 0}, {{m / 10, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {(k + m) / 10, 0.5, 0.5}};
    });
  }

  /// A corner of a box rotated by the triple 3, 4, 5.
  static Question map_centre() { return {{{12, 12, 0.5}, {{3, 4, 0}, {-4, 3, 0}, {0, 0, 0.5}}}, {11, 19, 0.5}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {12, 13}; }

  static Hooks<point_in_obb> hooks() {
    return {.as_open_sets = outside_if_on_boundary<Question>,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::affine, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
