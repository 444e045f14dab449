// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/many_points.h"
#include "catalogue/families/meshes/cloud_draws.h"
#include "catalogue/families/obb_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/volumes/obb_of_points.h"
#include "oracle/volumes/obb_of_points.h"
#include "reference/volumes/obb_of_points.h"
#include "robust/volumes/obb_of_points.h"

namespace touchstone::catalogue::rows {

struct obb_of_points : signatures::obb_of_points {
  using decision = NoDecision;

  template <class Real>
  static Obb3<Real> reference(const std::vector<Point3<Real>>& points) {
    return ::touchstone::reference::obb_of_points(points);
  }
  /// Eigenvectors are irrational: along those that the formula finds in double, put at right angles.
  static Obb3<Exact> reference(const std::vector<Point3<Exact>>& points) {
    Points doubles;
    double greatest = 0;
    for (const auto& p : points) {
      doubles.push_back({nearest(p.x.value()), nearest(p.y.value()), nearest(p.z.value())});
      const auto& [x, y, z] = doubles.back();
      greatest = std::max({greatest, std::fabs(x), std::fabs(y), std::fabs(z)});
    }
    const int up = greatest == 0 ? 0 : -std::ilogb(greatest);
    for (Point3d& p : doubles) p = {std::ldexp(p.x, up), std::ldexp(p.y, up), std::ldexp(p.z, up)};
    const auto [one, other, third] = ::touchstone::reference::covariance_axes(doubles);
    const auto exactly = [](const Vector3d& v) {
      const auto number = [](double x) { return Exact(exact_value(x)); };
      return Vector3<Exact>{number(v.x), number(v.y), number(v.z)};
    };
    const Vector3<Exact> u = exactly(one), w = cross(u, exactly(other));
    return ::touchstone::reference::box_along<Exact>({u, cross(w, u), w}, points);
  }
  static Obb3d robust(const Points& points) { return ::touchstone::robust::obb_of_points(points); }
  static auto oracle(const auto& points) -> decltype(::touchstone::oracle::obb_of_points(points)) {
    return ::touchstone::oracle::obb_of_points(points);
  }

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "volumes",
                                     .pages = "27",
                                     .question = "Which oriented box contains all of the points?",
                                     .kind = Kind::checked,
                                     .fields = {"points"},
                                     .answer = "obb",
                                     .margin_degree = 0,
                                     .cost = 7,
                                     .time = grows(Growth::linear),
                                     .list_length = 3,
                                     .longest_vector = 4000};

  static void hard_cases(HardCases<Question>& add) {
    add("in_a_box", [](DrawStream& c) -> Question {
      const Obb3d box = lattice_obb(c);
      return some_points(c, [&] { return in_obb(box, c); });
    });
    add("long_and_thin", [](DrawStream& c) -> Question {
      // Each axis of its own size: of two that differ by more than a double's digits the shorter is lost in the
      // rounding of the longer.
      Obb3d box{{0, 0, 0}, turned_half_axes(c)};
      for (Vector3d* axis : each_of(box.half_axes)) *axis = std::ldexp(1, -integer_in(c, 0, 119)) * *axis;
      return some_points(c, [&] { return in_obb(box, c); });
    });
    add("far_from_the_origin", [](DrawStream& c) -> Question {
      // The points differ in their last places, so that the center of their box is no double.
      const double far = power_of_two(c, 0, 39);
      const auto beside = [far](DrawStream& d) { return far * (1 + small_integer(d) * 0x1p-52); };
      return some_points(c, [&] { return point_of(c, beside); });
    });
    add("least_normal", [](DrawStream& c) -> Question {
      // Flat sets of sizes at which the thickness of a box becomes subnormal, and of which robust's guard says so.
      const int exponent = -850 - integer_in(c, 0, 223);
      const Vector3d v = lattice_normal(c, 8), w = lattice_normal(c, 8);
      return some_points(c, [&] {
        const double s = small_integer(c), t = small_integer(c);
        const Vector3d p = scaled(s * v + t * w, exponent);
        return Point3d{p.x, p.y, p.z};
      });
    });
    add("lost_beside_huge", [](DrawStream& c) -> Question {
      // All is huge and equal but for numbers that are next to nothing in comparison.
      const double part = 1 + ordinary(c), x = std::ldexp(part, 1020 - integer_in(c, 0, 199));
      return some_points(c, [&] {
        const double y = 1 + small_integer(c) * 0x1p-52;
        return Point3d{x, y, either_sign(c)};
      });
    });
    add("across_the_range", [](DrawStream& c) -> Question {
      // The half axes of a box along its diagonal are beyond the range.
      double end = -greatest_double;
      return some_points(c, [&] {
        end = -end;
        const double one = either_sign(c), y = c.one_in(8) ? one : end;
        return Point3d{end, y, c.coin() ? one : end};
      });
    });
    add("whole_range", [](DrawStream& c) -> Question {
      return some_points(c, [&c] {
        const double x = end_of_range(c), y = c.coin() ? end_of_range(c) : 0.0, one = either_sign(c);
        return Point3d{x, y, c.coin() ? end_of_range(c) : one};
      });
    });
    add("rounded",
        [](DrawStream& c) -> Question { return some_points(c, [&c] { return ordinary_point_in_space(c); }); });
    cloud_cases(add);
    add.unscaled("many_points", [](DrawStream& c) -> Question { return many_points_and_one_far(c); });
  }

  static std::string defect(const Question& question, const Obb3d& box) {
    return ::touchstone::oracle::obb_of_points_defect(std::get<0>(question), box);
  }
  static Excess excess(const Question& question, const Obb3d& box, const Obb3d&) {
    return excess_of_box(std::get<0>(question), box);
  }
  static std::string exact_defect(const Question& question, const Obb3<mpq_class>& box) {
    return ::touchstone::oracle::obb_of_points_defect(std::get<0>(question), box);
  }

  /// The corners of a rotated box and a point on one of its faces; moves that.
  static Question map_centre() {
    return {
        {{0, 0, 0}, {12, 9, 0}, {-3, 4, 0}, {9, 13, 0}, {0, 0, 1}, {12, 9, 1}, {-3, 4, 1}, {9, 13, 1}, {8, 6, 0.5}}};
  }
  static std::pair<std::size_t, std::size_t> map_axes() { return {24, 25}; }

  static Hooks<obb_of_points> hooks() {
    return {.defect = defect,
            .exact_defect = exact_defect,
            .excess = excess,
            .map_centre = map_centre,
            .map_axes = map_axes};
  }
};

}  // namespace touchstone::catalogue::rows
