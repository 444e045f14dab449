// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/box_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/volumes/aabb_aabb.h"
#include "oracle/volumes/aabb_aabb.h"
#include "reference/volumes/aabb_aabb.h"
#include "robust/batch/aabb_aabb.h"
#include "robust/volumes/aabb_aabb.h"

namespace touchstone::catalogue::rows {

struct aabb_aabb : signatures::aabb_aabb {
  TOUCHSTONE_STAGED_MODULES(aabb_aabb)
  TOUCHSTONE_ARRAYS(aabb_aabb)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "volumes",
                                     .pages = "45-47",
                                     .question = "Do the two axis-aligned boxes overlap, only touch, or neither?",
                                     .kind = Kind::decision,
                                     .fields = {"a", "b"},
                                     .answer = "contact"};

  static void hard_cases(HardCases<Question>& add) {
    add("shared_face", [](DrawStream& c) -> Question { return side_by_side(c, 1); });
    add("shared_edge", [](DrawStream& c) -> Question { return side_by_side(c, 2); });
    add("shared_corner", [](DrawStream& c) -> Question { return side_by_side(c, 3); });
    add("apart_on_one_axis", [](DrawStream& c) -> Question {
      const Aabb3d a = lattice_box(c);
      Aabb3d b = overlapping(a, c);
      const double gap = one_to(c, 4);
      switch (c.below(3)) {
        case 0: b = shifted(b, a.max.x - b.min.x + gap, 0, 0); break;
        case 1: b = shifted(b, 0, a.max.y - b.min.y + gap, 0); break;
        default: b = shifted(b, 0, 0, a.max.z - b.min.z + gap);
      }
      return seen(a, b, c);
    });
    add("nested", [](DrawStream& c) -> Question {
      const Aabb3d a = lattice_box(c);
      return seen(a, within(a, c), c);
    });
    add("flat_inside", [](DrawStream& c) -> Question {
      const Aabb3d a = lattice_box(c);
      Aabb3d b = overlapping(a, c);
      b.max.x = b.min.x;
      if (c.coin()) b.max.y = b.min.y;
      return seen(a, b, c);
    });
    add("both_flat", [](DrawStream& c) -> Question {
      Aabb3d a = lattice_box(c), b = overlapping(a, c);
      a.max.x = a.min.x;
      b.min.x = b.max.x = a.min.x + small_integer(c, 1);
      return seen(a, b, c);
    });
    add("points", [](DrawStream& c) -> Question {
      const Point3d p = lattice_point_of_box(c), q = c.coin() ? lattice_point_of_box(c) : p;
      return seen({p, p}, {q, q}, c);
    });
    add("subnormal", [](DrawStream& c) -> Question {
      const double p = subnormal(c, 3), q = subnormal(c, 3), r = subnormal(c, 3), s = subnormal(c, 3);
      return InPlane{{{std::min(p, q), 0}, {std::max(p, q), 1}}, {{std::min(r, s), -1}, {std::max(r, s), 1}}};
    });
    add("either_zero", [](DrawStream& c) -> Question {
      return InPlane{{{-1, zero(c)}, {zero(c), 1}}, {{zero(c), zero(c)}, {1, 1}}};
    });
    add("whole_range", [](DrawStream& c) -> Question {
      const double x = c.coin() ? greatest_double : 0x1p1000, y = small_integer(c);
      return InPlane{{{-greatest_double, -greatest_double}, {x, y}},
                     {{c.coin() ? x : -x, y}, {greatest_double, greatest_double}}};
    });
    add("typed_touch", [](DrawStream& c) -> Question {
      // As typed the one ends where the other begins.
      const double k = one_to(c, 9), m = one_to(c, 9);
      return InPlane{{{0, 0}, {k / 10 + m / 10, 1}}, {{(k + m) / 10, 0}, {2, 1}}};
    });
    add("wide", [](DrawStream& c) -> Question {
      const Vector3d by = fractions(c);
      const Aabb3d a = shifted(lattice_box(c, 12), by.x, by.y, by.z), other = overlapping(a, c);
      const double gap = std::ldexp(small_integer(c, 1), -20);
      const Aabb3d b = shifted(other, a.max.x - other.min.x + gap, 0, 0), wide = widened(a, b.max, c);
      return seen(wide, c.coin() ? widened(b, a.min, c) : b, c);
    });
  }

  static void repair(Question& question) {
    std::visit([](auto& boxes) { put_in_order(std::get<0>(boxes)), put_in_order(std::get<1>(boxes)); }, question);
  }

  /// They share the corner (12, 12): moves it of the first.
  static Question map_centre() { return InPlane{{{0.5, 0.5}, {12, 12}}, {{12, 12}, {24, 24}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {2, 3}; }

  static Hooks<aabb_aabb> hooks() {
    return {.as_open_sets = disjoint_if_touching<Question>,
            .repair = repair,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::axes, .scales = true, .exchanges = {{0, 1}}}};
  }

 private:
  /// In space, or the same without z.
  static Question seen(const Aabb3d& a, const Aabb3d& b, DrawStream& c) {
    if (!c.coin()) return InSpace{a, b};
    return InPlane{without_z(a), without_z(b)};
  }
  /// b begins where a ends along the first `axes` axes and overlaps it along the others.
  static Question side_by_side(DrawStream& c, int axes) {
    const Aabb3d a = lattice_box(c);
    Aabb3d b = overlapping(a, c);
    b = shifted(b, a.max.x - b.min.x, axes > 1 ? a.max.y - b.min.y : 0, axes > 2 ? a.max.z - b.min.z : 0);
    return c.coin() ? seen(b, a, c) : seen(a, b, c);
  }
};

}  // namespace touchstone::catalogue::rows
