// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/kdop_draws.h"
#include "catalogue/families/many_points.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/volumes/kdop_of_points.h"
#include "oracle/volumes/kdop_of_points.h"
#include "reference/volumes/kdop_of_points.h"
#include "robust/volumes/kdop_of_points.h"

namespace touchstone::catalogue::rows {

struct kdop_of_points : signatures::kdop_of_points {
  TOUCHSTONE_STAGED_MODULES(kdop_of_points)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "volumes",
      .pages = "43",
      .question = "Which slabs of these normals are the narrowest that hold all the points?",
      .kind = Kind::checked,
      .fields = {"points", "normals"},
      .answer = "slabs",
      .margin_degree = 0,
      .cost = 4,
      .time = grows(Growth::quadratic),
      .list_length = 1,
      .longest_vector = 6000};

  static void hard_cases(HardCases<Question>& add) {
    add("on_lattice", [](DrawStream& c) -> Question {
      return {points_of(c, [](DrawStream& d) { return integer(d, 30); }), normals_of(c, kdop_normal)};
    });
    add("across_the_normal", [](DrawStream& c) -> Question {
      // All points are on one plane, or an integer away from it.
      const Vector3d n = lattice_normal(c);
      const Point3d from = lattice_point_in_space(c);
      const Points points = until(c, 8, 4, [&](DrawStream& d) {
        Point3d p = from + lattice_across(d, n);
        p.x += d.one_in(4) ? small_integer(d, 1) : 0;
        return p;
      });
      return {points, {n}};
    });
    add("rounded", [](DrawStream& c) -> Question { return {points_of(c, ordinary), normals_of(c, usual_normal)}; });
    add("turned", [](DrawStream& c) -> Question {
      return {points_of(c, ordinary), normals_of(c, drawn_normal<ordinary>)};
    });
    add("of_unit_length", [](DrawStream& c) -> Question {
      return {points_of(c, typed), normals_of(c, [](DrawStream& d) {
                const Vector3d n = usual_normal(d);
                const double length = std::sqrt(dot(n, n));
                return Vector3d{n.x / length, n.y / length, n.z / length};
              })};
    });
    add("nearly_equal", [](DrawStream& c) -> Question {
      // The last digits alone decide which of them is outermost.
      const Point3d p = ordinary_point_in_space(c);
      const auto moved = [](double number, DrawStream& d) { return ulps_apart(d, number, 4); };
      return {until(c, 16, 6,
                    [&](DrawStream& d) {
                      return Point3d{moved(p.x, d), moved(p.y, d), moved(p.z, d)};
                    }),
              normals_of(c, kdop_normal)};
    });
    add("cancelling", [](DrawStream& c) -> Question {
      // Sums that cancel all but a little of the products, or all of them.
      return {until(c, 8, 4,
                    [](DrawStream& d) {
                      const int exponent = integer_in(d, 40, 99);
                      const double x = std::ldexp(one_to(d, 8), exponent);
                      return Point3d{x, d.coin() ? ulps_apart(d, x, 4) : x, small_integer(d)};
                    }),
              {{1, -1, c.coin() ? 1.0 : 0x1p-60}}};
    });
    add("as_wide_as_a_lattice", [](DrawStream& c) -> Question {
      // The terms span about 124 binary digits, from where on their sum does not fit two words.
      const int exponent = integer_in(c, 57, 60);
      const double x = std::ldexp(8 + up_to(c, 7), exponent), y = c.coin() ? x : -x, sign = either_sign(c);
      return {{{x, y, small_integer(c, 2)}, {x, y, small_integer(c, 2)}}, {{x, sign * x, 1}}};
    });
    add("below_least", [](DrawStream& c) -> Question {
      // Products of about the least subnormal number, or half of it.
      const int k = integer_in(c, -500, 499);
      const auto part = [k](DrawStream& d) { return std::ldexp(one_to(d, 4), k); };
      return {points_of(c, [k](DrawStream& d) { return std::ldexp(small_integer(d), -1077 - k); }),
              normals_of(c, [&](DrawStream& d) {
                return Vector3d{part(d), part(d), d.coin() ? part(d) : 0.0};
              })};
    });
    add("beyond_range", [](DrawStream& c) -> Question {
      return {points_of(c, [](DrawStream& d) { return std::ldexp(small_integer(d), 1020); }),
              normals_of(c, kdop_normal)};
    });
    add("at_the_range", [](DrawStream& c) -> Question {
      // The greatest double, and more by half a unit in its last place, or by a hair.
      const Points points = until(c, 6, 3, [](DrawStream& d) {
        static constexpr double beside[]{0, 0x1p969, 0x1p970, 0x1p971, 0x1p-1074, 1};
        const double y = beside[d.below(6)], sign = either_sign(d);
        return Point3d{sign * greatest_double, d.coin() ? y : -y, 0};
      });
      return {points, {{1, 1, 0}}};
    });
    add("either_zero", [](DrawStream& c) -> Question { return {points_of(c, zero), normals_of(c, kdop_normal)}; });
    add("few", [](DrawStream& c) -> Question {
      const Point3d p = lattice_point_in_space(c);
      const Vector3d n = c.one_in(4) ? Vector3d{0.0, -0.0, 0.0} : kdop_normal(c);
      return {Points(c.below(3), p), Normals(c.below(3), n)};
    });
    add.unscaled("many_points", [](DrawStream& c) -> Question {
      return {many_points_and_one_far(c), normals_of(c, usual_normal)};
    });
    add.unscaled("many_normals", [](DrawStream& c) -> Question {
      return {points_of(c, [](DrawStream& d) { return integer(d, 8); }), many_normals(c)};
    });
  }

  static std::string defect(const Question& question, const std::vector<Slabd>& slabs) {
    return ::touchstone::oracle::kdop_of_points_defect(std::get<0>(question), std::get<1>(question), slabs);
  }
  static Excess excess(const Question& question, const std::vector<Slabd>& slabs, const std::vector<Slabd>&) {
    return excess_of_slabs(std::get<0>(question), std::get<1>(question), slabs);
  }

  /// Normals have no unit: they keep their values.
  static void scale(Question& question, int k) {
    for (Point3d& p : std::get<0>(question)) p = {std::ldexp(p.x, k), std::ldexp(p.y, k), std::ldexp(p.z, k)};
  }

  /// The sum of the first point's coordinates, x + y + z, is the greatest: moves two of these.
  static Question map_centre() { return {{{0.1, 0.2, 0.3}, {0, 0, 0}}, {{1, 1, 1}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<kdop_of_points> hooks() {
    return {.defect = defect, .excess = excess, .scale = scale, .map_centre = map_centre, .map_axes = map_axes};
  }

 private:
  template <double (*number)(DrawStream&)>
  static Vector3d drawn_normal(DrawStream& c) {
    const double x = number(c), y = number(c), z = number(c);
    return {x, y, z == 0 ? 1 : z};
  }

  template <class Draw>
  static Points points_of(DrawStream& c, const Draw& number) {
    return until(c, 16, 6, [&](DrawStream& d) { return point_of(d, number); });
  }
  template <class Draw>
  static Normals normals_of(DrawStream& c, const Draw& normal) {
    return until(c, 7, 3, normal);
  }
};

}  // namespace touchstone::catalogue::rows
