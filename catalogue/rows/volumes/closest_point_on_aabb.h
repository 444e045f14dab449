// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/box_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/volumes/closest_point_on_aabb.h"
#include "oracle/volumes/closest_point_on_aabb.h"
#include "reference/volumes/closest_point_on_aabb.h"
#include "robust/volumes/closest_point_on_aabb.h"

namespace touchstone::catalogue::rows {

struct closest_point_on_aabb : signatures::closest_point_on_aabb {
  TOUCHSTONE_MODULES_EITHER(closest_point_on_aabb)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "volumes",
                                     .pages = "48-50",
                                     .question = "Which point of an axis-aligned box is nearest to the point?",
                                     .kind = Kind::measure,
                                     .fields = {"point", "aabb"},
                                     .answer = "point",
                                     .margin_degree = 0};

  static void hard_cases(HardCases<Question>& add) {
    add("beyond", [](DrawStream& c) -> Question {
      const Aabb3d box = lattice_box(c);
      return seen(around(box, c), box, c);
    });
    add("inside", [](DrawStream& c) -> Question {
      const Aabb3d box = lattice_box(c);
      return seen(within(box, c).min, box, c);
    });
    add("flat", [](DrawStream& c) -> Question {
      const Point3d p = lattice_point_of_box(c);
      Aabb3d box = lattice_box(c);
      box.max.x = box.min.x = p.x + small_integer(c, 1);
      if (c.coin()) box.max.y = box.min.y;
      if (c.coin()) box.max.z = box.min.z;
      return seen(p, box, c);
    });
    add("subnormal", [](DrawStream& c) -> Question {
      const double p = subnormal(c, 3), q = subnormal(c, 3), x = subnormal(c, 3), y = subnormal(c, 3);
      return InPlane{{x, y}, {{std::min(p, q), std::min(p, q)}, {std::max(p, q), 1}}};
    });
    add("either_zero", [](DrawStream& c) -> Question {
      return InPlane{{zero(c), zero(c)}, {{zero(c), -1}, {zero(c), zero(c)}}};
    });
    add("whole_range", [](DrawStream& c) -> Question {
      const double x = c.coin() ? greatest_double : -greatest_double, y = c.coin() ? 0x1p1000 : 0x1p-1000;
      return InPlane{{x, y}, {{c.coin() ? -greatest_double : -0x1p1023, -y}, {greatest_double, small_integer(c)}}};
    });
    add("wide", [](DrawStream& c) -> Question {
      const Vector3d by = fractions(c);
      const Aabb3d box = shifted(lattice_box(c, 12), by.x, by.y, by.z);
      const Point3d p = around(box, c);
      return seen(p, widened(box, p, c), c);
    });
  }

  static void repair(Question& question) {
    std::visit([](auto& asked) { put_in_order(std::get<1>(asked)); }, question);
  }

  /// Moves a point at the corner (12, 12).
  static Question map_centre() { return InPlane{{12, 12}, {{0.5, 0.5}, {12, 12}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<closest_point_on_aabb> hooks() {
    return {.repair = repair,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }

 private:
  /// On each axis below the box, in it, at an end or above: faces, edges and corners.
  static Point3d around(const Aabb3d& box, DrawStream& c) {
    const auto coordinate = [&c](double min, double max) {
      const auto far = up_to(c, 7);
      switch (c.below(3)) {
        case 0: return min - far;
        case 1: return max + far;
        default: return std::min(min + far, max);
      }
    };
    return {coordinate(box.min.x, box.max.x), coordinate(box.min.y, box.max.y), coordinate(box.min.z, box.max.z)};
  }

  /// In space, or the same without z.
  static Question seen(const Point3d& point, const Aabb3d& box, DrawStream& c) {
    if (!c.coin()) return InSpace{point, box};
    return InPlane{{point.x, point.y}, without_z(box)};
  }
};

}  // namespace touchstone::catalogue::rows
