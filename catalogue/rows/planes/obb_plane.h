// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/half_space_draws.h"
#include "catalogue/families/obb_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/planes/obb_plane.h"
#include "oracle/planes/obb_plane.h"
#include "reference/planes/obb_plane.h"
#include "robust/planes/obb_plane.h"

namespace touchstone::catalogue::rows {

struct obb_plane : signatures::obb_plane, OverPlane<Obb3d> {
  TOUCHSTONE_STAGED_MODULES(obb_plane)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "planes",
      .pages = "22, 27",
      .question =
          "Do an oriented box and the half-space N . p + d <= 0 behind a plane overlap, only touch, or neither?",
      .kind = Kind::decision,
      .fields = {"obb", "plane"},
      .answer = "contact",
      .margin_degree = 2,
      .longest_vector = 2300};

  static void hard_cases(HardCases<Question>& add) {
    add("corner_on_plane", [](DrawStream& c) -> Question {
      const Obb3d box = lattice_obb(c);
      return over_plane(c, box, lattice_normal(c));
    });
    add("edge_or_face_on_plane", [](DrawStream& c) -> Question {
      const Obb3d box{lattice_point_in_space(c, 20), c.coin() ? turned_half_axes(c) : skew_half_axes(c)};
      const auto& [u, v, w] = box.half_axes;
      const Vector3d across = lattice_across(c, u);
      return over_plane(c, box, validation::still(across) ? cross(v, w) : across);
    });
    add("nearly_dependent", [](DrawStream& c) -> Question {
      const Obb3d box{lattice_point_in_space(c, 20), slanted_half_axes(c)};
      const auto& [u, v, w] = box.half_axes;
      return over_plane(c, box, c.coin() ? lattice_normal(c, 40) : beside(Vector3d{u.y, -u.x, 0}, c));
    });
    add("dependent", [](DrawStream& c) -> Question {
      const Vector3d u = lattice_normal(c), v = lattice_normal(c);
      const double r = small_integer(c), s = small_integer(c);
      return {{lattice_point_in_space(c, 20), {u, r * u + s * v, v}}, {lattice_normal(c, 4), small_integer(c)}};
    });
    add("long_and_thin", [](DrawStream& c) -> Question {
      const Obb3d box = long_and_thin_obb(c);
      const Vector3d n = lattice_normal(c, 4);
      return {box, {n, within_ulps(c, -lowest(box, n), 1)}};
    });
    add("rounded_onto_plane", [](DrawStream& c) -> Question {
      const Obb3d box{ordinary_point_in_space(c), ordinary_half_axes(c)};
      const Vector3d n{ordinary(c), ordinary(c), 1};
      return {box, {n, within_ulps(c, -lowest(box, n), 1)}};
    });
    add("typed_shapes", [](DrawStream& c) -> Question {
      // As typed a corner of a box that is turned by the triple 3, 4, 5 is on the plane.
      const double k = one_to(c, 9), m = one_to(c, 9);
      return {{{0, m / 10, 0}, {{3 * k / 10, 4 * k / 10, 0}, {-0.8, 0.6, 0}, {0, 0, 1}}},
              {{0, 1, 0}, (4 * k + 6 - m) / 10}};
    });
    add("normal_of_any_size", [](DrawStream& c) -> Question {
      // A face on the plane but for a part that counts for little, or for nothing.
      const int k = integer_in(c, -1050, 949), m = integer_in(c, 0, 299);
      const double n = std::ldexp(5 + up_to(c, 2), k), half = one_to(c, 2);
      return {{{half, 0, 0}, {{half, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
              {{n, std::ldexp(small_integer(c, 1), k - m), 0}, 0}};
    });
    add("terms_below_least", [](DrawStream& c) -> Question {
      const auto [plane, corner] = terms_below_least(c);
      const auto& [x, y, z] = corner;
      return {{{2 * x, 2 * y, 2 * z}, {{x, 0, 0}, {0, y, 0}, {0, 0, z}}}, plane};
    });
    add("off_by_a_hair", [](DrawStream& c) -> Question {
      const double size = scaled_up(c, 4, 1020), off = small_integer(c, 1);
      const double hair = std::ldexp(off, -integer_in(c, 0, 1073));
      return {{{hair, 0, size}, {{size, 0, 0}, {size, size, 0}, {0, 0, size}}}, {{1, 1, 0}, 3 * size}};
    });
    add("moderate_ends", [](DrawStream& c) -> Question {
      // The greatest and the least numbers that the filter takes, and the next beyond them; near the plane or far.
      const double large = power_of_two(c, 29, 31), least = power_of_two(c, -32, -29), off = small_integer(c, 1);
      const double far = c.coin() ? 0 : large / 2;
      return {{{large + far, 0, 0}, {{large, 0, 0}, {0, least, 0}, {0, 0, 1}}}, {{large, least, 0}, off * least}};
    });
    add("whole_range", [](DrawStream& c) -> Question {
      // Products overflow, and where nothing does, their sum.
      const double great = huge(c), n = c.coin() ? great : 1, far = c.coin() ? great : small_integer(c);
      return {{{great, far, 0}, {{great, 0, 0}, {0, c.coin() ? great : 1, 0}, {far, 0, 1}}},
              {{n, c.coin() ? -n : 1, 0}, c.one_in(3) ? -great : small_integer(c, 1)}};
    });
    add("either_zero", [](DrawStream& c) -> Question {
      const Obb3d box{zero_point(c), {{1, zero(c), zero(c)}, {zero(c), -1, zero(c)}, {zero(c), zero(c), 1}}};
      const double n = zero(c), offset = small_integer(c, 1);
      return {box, {{n, 1, n}, offset == 0 ? zero(c) : offset}};
    });
    add("zero_normal", [](DrawStream& c) -> Question {
      const Vector3d n{0.0, zero(c), 0.0};
      return {lattice_obb(c), {n, small_integer(c)}};
    });
  }

  static Hooks<obb_plane> hooks() {
    return {.as_open_sets = disjoint_if_touching<Question>,
            .scale = scale,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }

 private:
  static double lowest(const Obb3d& box, const Vector3d& n) {
    const auto& [u, v, w] = box.half_axes;
    const Point3d& c = box.center;
    return dot(n, Vector3d{c.x, c.y, c.z}) - (std::fabs(dot(n, u)) + std::fabs(dot(n, v)) + std::fabs(dot(n, w)));
  }
  /// The height of the lowest corner, in units of the length of the normal: it is on the plane or next to it, or deep.
  static Question over_plane(DrawStream& c, const Obb3d& box, const Vector3d& n) {
    const double height = small_integer(c, 1), below = c.one_in(4) ? up_to(c, 999) : 0.0;
    return {box, {n, height - below - lowest(box, n)}};
  }
};

}  // namespace touchstone::catalogue::rows
