// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/bodies/bounce_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/response/penalty_force.h"
#include "oracle/response/penalty_force.h"
#include "reference/response/penalty_force.h"
#include "robust/response/penalty_force.h"

namespace touchstone::catalogue::rows {

struct penalty_force : signatures::penalty_force {
  TOUCHSTONE_STAGED_MODULES(penalty_force)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "response",
      .pages = "72-73",
      .question = "With which force do a spring and a damper act on a particle behind a plane?",
      .kind = Kind::measure,
      .fields = {"point", "velocity", "plane", "stiffness", "damping"},
      .answer = "force",
      .ulps = 22,
      .margin_degree = 2,
      .longest_vector = 4000};

  static void hard_cases(HardCases<Question>& add) {
    add("behind", [](DrawStream& c) -> Question { return usual(c, -scaled_up(c, 8, 40)); });
    add("beside_plane", [](DrawStream& c) -> Question { return usual(c, small_integer(c, 1)); });
    add("along_the_plane", [](DrawStream& c) -> Question {
      Question q = usual(c, -1);
      std::get<1>(q) = lattice_across(c, std::get<2>(q).normal);
      return q;
    });
    add("balanced", [](DrawStream& c) -> Question {
      // The damper holds what the spring pulls, or nearly.
      const double depth = one_to(c, 1 << 20), part = one_to(c, 64);
      Question q = usual(c, -depth);
      const double leaving = dot(std::get<1>(q), std::get<2>(q).normal);
      std::get<3>(q) = part * leaving;
      std::get<4>(q) = part * depth + small_integer(c, 1);
      return q;
    });
    add("stretched_normal", [](DrawStream& c) -> Question {
      const auto [p, v, plane, k, d] = usual(c, -1 - small_integer(c, 1));
      const int unit = integer_in(c, -1050, 949);
      return {p, v, {scaled(plane.normal, unit), std::ldexp(plane.offset, unit)}, k, d};
    });
    add("products_at_the_end", [](DrawStream& c) -> Question {
      const Bounce b = products_at_the_end(c);
      const Vector3d p = ordinary_vector(c);
      const double offset = at_the_end(c, -500), k = ordinary(c), size = at_the_end(c, 500);
      return {{p.x, p.y, p.z}, b.velocity, {b.normal, offset}, k, c.coin() ? size : k};
    });
    add("terms_below_least", [](DrawStream& c) -> Question {
      const auto [plane, p] = terms_below_least(c);
      return {p, lattice_velocity(c, 4), plane, 1, small_integer(c)};
    });
    add("at_end_of_range", [](DrawStream& c) -> Question {
      const Vector3d p = at_the_end_of_range(c), v = at_the_end_of_range(c), n = lattice_normal(c, 3);
      const double k = std::ldexp(1, -integer_in(c, 0, 3));
      return {{p.x, p.y, p.z}, v, {n, small_integer(c)}, k, small_integer(c)};
    });
    add("beside_a_tie", [](DrawStream& c) -> Question {
      // depth times stiffness and the damper's rest make an odd number of 54 digits, and a little.
      const NearTie tie = near_tie(c);
      const Vector3d n{0, power_of_two(c, 0, 3), 0};
      return {{integer(c, 20), -tie.v, 0}, {0, -tie.rest, 0}, {n, 0}, tie.t, 1};
    });
    add("typed_on_plane", [](DrawStream& c) -> Question {
      // As typed the point is on the plane.
      const double k = one_to(c, 9), m = one_to(c, 9);
      return {{k / 10, m / 10, 0}, {0, -1, 0}, {{1, 1, 0}, -(k + m) / 10}, typed(c), 0.1};
    });
    add("without_a_normal", [](DrawStream& c) -> Question {
      Question q = usual(c, -1);
      std::get<2>(q).normal = zero_vector(c);
      return q;
    });
  }

  /// The normal, the stiffness and the damping are units of their own: they keep their values.
  static void scale(Question& question, int exponent) {
    auto& [p, v, plane, k, d] = question;
    lengthen(p, exponent), lengthen(v, exponent), plane.offset = std::ldexp(plane.offset, exponent);
  }

  /// On the plane: moves the point's y and the velocity's y.
  static Question map_centre() { return {{1, -1, 0}, {0, -1, 0}, {{1, 1, 0}, 0}, 1, 0.5}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {1, 4}; }

  static Hooks<penalty_force> hooks() {
    return {.scale = scale, .map_centre = map_centre, .map_axes = map_axes, .laws = {.scales = true}};
  }

 private:
  /// A lattice point over a plane by that height, in units of the normal.
  static Question usual(DrawStream& c, double height) {
    const Vector3d n = lattice_normal(c, 16), v = lattice_velocity(c, 20);
    const Point3d foot = lattice_point_in_space(c, 20), p = foot + lattice_across(c, n);
    return {p, v, {n, height - dot(n, Vector3d{foot.x, foot.y, foot.z})}, one_to(c, 1 << 10), small_integer(c)};
  }
};

}  // namespace touchstone::catalogue::rows
