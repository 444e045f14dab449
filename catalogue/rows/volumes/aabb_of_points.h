// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/box_draws.h"
#include "catalogue/families/many_points.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/volumes/aabb_of_points.h"
#include "oracle/volumes/aabb_of_points.h"
#include "reference/volumes/aabb_of_points.h"
#include "robust/volumes/aabb_of_points.h"

namespace touchstone::catalogue::rows {

struct aabb_of_points : signatures::aabb_of_points {
  TOUCHSTONE_MODULES_EITHER(aabb_of_points)
  using stages = ::touchstone::robust::stages::aabb_of_points;
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "volumes",
                                     .pages = "28-30",
                                     .question = "Which is the least axis-aligned box that holds all the points?",
                                     .kind = Kind::measure,
                                     .fields = {"points"},
                                     .answer = "aabb",
                                     .margin_degree = 0,
                                     .time = grows(Growth::linear),
                                     .list_length = 3};

  static void hard_cases(HardCases<Question>& add) {
    add("on_lattice", [](DrawStream& c) -> Question { return seen(lattice_points(c), c); });
    add("one_point", [](DrawStream& c) -> Question { return seen({lattice_point_of_box(c)}, c); });
    add("flat", [](DrawStream& c) -> Question {
      InSpace points = lattice_points(c);
      const std::uint64_t axes = c.below(3);
      for (Point3d& p : points) {
        p.y = points[0].y;
        if (axes > 0) p.x = points[0].x;
        if (axes > 1) p.z = points[0].z;
      }
      return seen(points, c);
    });
    add("in_order", [](DrawStream& c) -> Question {
      // The first point and the last are the ends on each axis.
      InSpace points = lattice_points(c);
      const auto sort = [&](double Point3d::*axis) {
        std::vector<double> numbers;
        for (const Point3d& p : points) numbers.push_back(p.*axis);
        std::sort(numbers.begin(), numbers.end());
        if (c.coin()) std::reverse(numbers.begin(), numbers.end());
        for (std::size_t i = 0; i < points.size(); ++i) points[i].*axis = numbers[i];
      };
      sort(&Point3d::x), sort(&Point3d::y), sort(&Point3d::z);
      return seen(points, c);
    });
    add("either_zero", [](DrawStream& c) -> Question { return seen(points_of(c, zero), c); });
    add("subnormal", [](DrawStream& c) -> Question {
      // All of these are equal in an environment that reads subnormals as zero.
      const double shift = small_integer(c, 4);
      return seen(points_of(c, [shift](DrawStream& d) { return (shift + small_integer(d, 4)) * 0x1p-1074; }), c);
    });
    add("beside_normal", [](DrawStream& c) -> Question {
      const double sign = either_sign(c);
      return seen(points_of(c, [sign](DrawStream& d) { return sign * ulps_apart(d, 0x1p-1022, 4); }), c);
    });
    add("whole_range", [](DrawStream& c) -> Question {
      const auto end = [](DrawStream& d) {
        const double size = std::array{greatest_double, 0x1p1023, 1.0, 0x1p-1074}[d.below(4)];
        return either_sign(d) * size;
      };
      return seen(points_of(c, end), c);
    });
    add("an_ulp_apart", [](DrawStream& c) -> Question {
      const double size = typed(c);
      return seen(points_of(c, [size](DrawStream& d) { return ulps_apart(d, size, 4); }), c);
    });
    add("few", [](DrawStream& c) -> Question {
      const std::size_t count = c.below(3);
      return seen(InSpace(count, lattice_point_of_box(c)), c);
    });
    add.unscaled("many_points", [](DrawStream& c) -> Question { return seen(many_points_and_one_far(c), c); });
  }

  /// A box whose upper right corner is one of the points, which moves.
  static Question map_centre() { return std::tuple(InPlane{{0, 0}, {8, 3}, {5, 8}, {8, 8}}); }

  static Hooks<aabb_of_points> hooks() {
    return {.map_centre = map_centre, .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }

 private:
  /// In space, or the same without z.
  static Question seen(const InSpace& points, DrawStream& c) {
    if (!c.coin() && !points.empty()) return std::tuple(points);  // an empty list is read as one of the plane
    InPlane seen;
    for (const Point3d& p : points) seen.push_back({p.x, p.y});
    return std::tuple(seen);
  }
  template <class Draw>
  static InSpace points_of(DrawStream& c, const Draw& number) {
    return until(c, 24, 6, [&](DrawStream& d) { return point_of(d, number); });
  }
  static InSpace lattice_points(DrawStream& c) {
    return points_of(c, [](DrawStream& d) { return integer(d, 53); });
  }
};

}  // namespace touchstone::catalogue::rows
