// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "catalogue/families/many_points.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/volumes/bounding_sphere.h"
#include "oracle/volumes/bounding_sphere.h"
#include "reference/volumes/bounding_sphere.h"
#include "robust/volumes/bounding_sphere.h"

namespace touchstone::catalogue::rows {

struct bounding_sphere : signatures::bounding_sphere {
  using decision = NoDecision;

  static SphereMethod method_of(const Method& method) { return method.value_or(SphereMethod::smallest); }

  template <class Real>
  static auto reference(const std::vector<Point3<Real>>& points, const Method& method) {
    return ::touchstone::reference::bounding_sphere(points, method_of(method));
  }
  static Sphere3d robust(const std::vector<Point3d>& points, const Method& method) {
    return ::touchstone::robust::bounding_sphere(points, method_of(method));
  }
  template <class Real>
  static auto oracle(const std::vector<Point3<Real>>& points, const Method& method) {
    return ::touchstone::oracle::bounding_sphere(points, method_of(method));
  }

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "volumes",
                                     .pages = "31-34",
                                     .question = "Which ball, found by that method, contains all of the points?",
                                     .kind = Kind::checked,
                                     .fields = {"points", "method"},
                                     .answer = "sphere",
                                     .margin_degree = 0,
                                     .cost = 6,
                                     .time = grows(Growth::linear),
                                     .list_length = 4,
                                     .longest_vector = 6000};

  static void hard_cases(HardCases<Question>& add) {
    add("on_a_sphere", [](DrawStream& c) -> Question {
      // Displacements of length 3 k around a lattice point, by the quadruples 1, 2, 2 and 3, 0, 0.
      static constexpr std::array<std::array<double, 3>, 2> steps{{{1, 2, 2}, {3, 0, 0}}};
      const Point3d center = lattice_point_in_space(c, 20);
      const double k = one_to(c, 1 << 12);
      return many(c, [&] {
        const auto& step = steps[c.below(2)];
        const std::size_t from = c.below(3);
        const auto part = [&](std::size_t i) { return either_sign(c) * k * step[(from + i) % 3]; };
        return center + Vector3d{part(0), part(1), part(2)};
      });
    });
    add("on_a_line", [](DrawStream& c) -> Question {
      const Point3d p = lattice_point_in_space(c, 20);
      const Vector3d v = lattice_normal(c, 12);
      return many(c, [&] { return p + small_integer(c) * v; });
    });
    add("on_a_plane", [](DrawStream& c) -> Question {
      const Point3d p = lattice_point_in_space(c, 20);
      const Vector3d v = lattice_normal(c, 12), w = lattice_normal(c, 12);
      return many(c, [&] {
        const double s = small_integer(c), t = small_integer(c);
        return p + s * v + t * w;
      });
    });
    add("corners_of_a_box", [](DrawStream& c) -> Question {
      const Point3d p = lattice_point_in_space(c, 20);
      const Vector3d widths{up_to(c, 7), up_to(c, 7), up_to(c, 7)};
      return many(c, [&] {
        return p + Vector3d{c.coin() ? widths.x : 0, c.coin() ? widths.y : 0, c.coin() ? widths.z : 0};
      });
    });
    add("equal", [](DrawStream& c) -> Question {
      const Point3d p = point_of(c, any_finite);
      return many(c, [&p] { return p; });
    });
    add("far_from_the_origin", [](DrawStream& c) -> Question {
      // The points differ in their last places, so that the center of their ball is no double.
      const double far = power_of_two(c, 0, 39);
      const auto beside = [far](DrawStream& d) { return far * (1 + small_integer(d) * 0x1p-52); };
      return many(c, [&] { return point_of(c, beside); });
    });
    add("one_far_away", [](DrawStream& c) -> Question {
      // One point at a distance next to which the others are nothing, or just something.
      const double far = power_of_two(c, 0, 999);
      Question question = many(c, [&c] { return lattice_point_in_space(c, 3); });
      std::get<0>(question).push_back({far, 0, 0});
      return question;
    });
    add("subnormal", [](DrawStream& c) -> Question {
      return many(c, [&c] { return Point3d{subnormal(c), subnormal(c), c.coin() ? -0.0 : 0x1p-1074}; });
    });
    add("whole_range", [](DrawStream& c) -> Question {
      return many(c, [&c] {
        const double x = end_of_range(c), y = c.coin() ? end_of_range(c) : 0.0;
        return Point3d{x, y, c.coin() ? end_of_range(c) : 1.0};
      });
    });
    add("rounded_on_a_sphere", [](DrawStream& c) -> Question {
      // Off the unit sphere, by roundings.
      return many(c, [&c] {
        const auto [x, y, z] = ordinary_point_in_space(c);
        const double length = std::sqrt(x * x + y * y + z * z);
        return length == 0 ? Point3d{1, 0, 0} : Point3d{x / length, y / length, z / length};
      });
    });
    add.unscaled("many_points", [](DrawStream& c) -> Question {
      return {many_points_and_one_far(c), drawn_method(c)};
    });
  }

  /// An empty list gets one point.
  static void repair(Question& question) {
    if (std::get<0>(question).empty()) std::get<0>(question).push_back({1, 2, 3});
  }

  static std::string defect(const Question& question, const Sphere3d& sphere) {
    const auto& [points, method] = question;
    return ::touchstone::oracle::bounding_sphere_defect(points, method_of(method), sphere);
  }
  static Excess excess(const Question& question, const Sphere3d& sphere, const Sphere3d& right) {
    return excess_of_ball(std::get<0>(question), sphere, right);
  }

  /// Four points on one sphere; moves the last.
  static Question map_centre() { return {{{1, 2, 2}, {-2, -1, 2}, {2, -2, 1}, {-1, 2, -2}}, std::nullopt}; }

  static Hooks<bounding_sphere> hooks() {
    return {.defect = defect, .excess = excess, .repair = repair, .map_centre = map_centre, .laws = {.scales = true}};
  }

 private:
  /// Some points, and a method.
  template <class Draw>
  static Question many(DrawStream& c, const Draw& draw) {
    return {some_points(c, draw), drawn_method(c)};
  }
  static Method drawn_method(DrawStream& c) {
    const std::uint64_t word = c.below(5);
    return word == 0 ? Method() : static_cast<SphereMethod>(4 - word);
  }
};

}  // namespace touchstone::catalogue::rows
