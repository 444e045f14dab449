// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/box_draws.h"
#include "catalogue/families/half_space_draws.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/aabb_plane.h"
#include "oracle/mixed/aabb_plane.h"
#include "reference/mixed/aabb_plane.h"
#include "robust/mixed/aabb_plane.h"

namespace touchstone::catalogue::rows {

struct aabb_plane : signatures::aabb_plane, OverPlane<Aabb3d> {
  TOUCHSTONE_STAGED_MODULES(aabb_plane)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "mixed",
      .pages = "22, 45-47",
      .question = "Do a box and the half-space N . p + d <= 0 behind a plane overlap, only touch, or neither?",
      .kind = Kind::decision,
      .fields = {"aabb", "plane"},
      .answer = "contact",
      .margin_degree = 2};

  static void hard_cases(HardCases<Question>& add) {
    add("corner_on_plane", [](DrawStream& c) -> Question {
      const Vector3d n = lattice_normal(c);
      const Aabb3d box = lattice_box(c);
      return over_plane(c, box, n, small_integer(c, 1));
    });
    add("edge_or_face_on_plane", [](DrawStream& c) -> Question {
      const auto slope = [&c] { return c.coin() ? small_integer(c, 3) : 0.0; };
      const double x = slope(), z = slope(), y = x == 0 && z == 0 ? 1 : slope();
      const Aabb3d box = lattice_box(c);
      return over_plane(c, box, {x, y, z}, small_integer(c, 1));
    });
    add("behind_plane", [](DrawStream& c) -> Question {
      const Vector3d n = lattice_normal(c, 4);
      const Aabb3d box = lattice_box(c, 8);
      return over_plane(c, box, n, -up_to(c, 999));
    });
    add("flat", [](DrawStream& c) -> Question {
      // A rectangle, a segment or a point, in front of the plane, on it, through it or behind it.
      Aabb3d box = lattice_box(c);
      flatten(box, c);
      const Vector3d n = lattice_normal(c, 4);
      return over_plane(c, box, n, small_integer(c));
    });
    add("nearly_flat", [](DrawStream& c) -> Question {
      // As wide as one unit in the last place, or a subnormal number.
      Aabb3d box = lattice_box(c);
      box.max.x = moved_by_ulps(box.min.x, integer_in(c, 0, 2));
      const Vector3d n = lattice_normal(c, 4);
      return over_plane(c, box, n, small_integer(c, 1));
    });
    add("needle_or_plate", [](DrawStream& c) -> Question {
      Aabb3d box = lattice_box(c, 4);
      box.max.x += scaled_up(c, 8, 40);
      if (c.coin()) box.max.y += scaled_up(c, 8, 40);
      const Vector3d n = lattice_normal(c, 12);
      return over_plane(c, box, n, small_integer(c, 1));
    });
    add("rounded_onto_plane", [](DrawStream& c) -> Question {
      const Vector3d n{ordinary(c), ordinary(c), 1};
      const Point3d p = ordinary_point_in_space(c);
      const Aabb3d box{p, p + Vector3d{0.25, 0.5, 1}};
      return {box, {n, within_ulps(c, -dot(n, lowest(box, n)), 1)}};
    });
    add("typed_shapes", [](DrawStream& c) -> Question {
      const double nx = typed(c), x = typed(c), y = typed(c), z = typed(c);
      const Vector3d n{nx, typed(c), 1};
      const Aabb3d box{{x, y, z}, {x + 0.1, y + 0.2, z + 0.3}};
      return {box, {n, -dot(n, lowest(box, n))}};
    });
    add("normal_of_any_size", [](DrawStream& c) -> Question {
      // The lowest corner on the plane but for a part that counts for little, or for nothing.
      const int k = integer_in(c, -1050, 949), m = integer_in(c, 0, 299);
      const double n = std::ldexp(5 + up_to(c, 2), k), width = up_to(c, 2);
      return {{{0, -1, -1}, {width, 1, 1}}, {{n, std::ldexp(small_integer(c, 1), k - m), 0}, 0}};
    });
    add("terms_below_least", [](DrawStream& c) -> Question {
      const auto [plane, corner] = terms_below_least(c);
      return {{corner, {1, 1, c.coin() ? corner.z : 1}}, plane};
    });
    add("as_wide_as_a_lattice", [](DrawStream& c) -> Question {
      // The terms span about 124 binary digits, from where on their sum does not fit two words.
      const double size = 8 + up_to(c, 7), off = small_integer(c, 1);
      const double x = std::ldexp(size, integer_in(c, 57, 60));
      return {{{x, -x, x}, {2 * x, x, c.coin() ? x : 2 * x}}, {{x, x, off}, off}};
    });
    add("off_by_a_hair", [](DrawStream& c) -> Question {
      const double size = scaled_up(c, 4, 1020), off = small_integer(c, 1);
      const double hair = std::ldexp(off, -integer_in(c, 0, 1073));
      return {{{-size, -size, 0}, {size, size, size}}, {{1, either_sign(c), 0}, 2 * size + hair}};
    });
    add("whole_range", [](DrawStream& c) -> Question {
      // Products overflow, and where nothing does, their sum.
      const double great = huge(c), n = c.coin() ? great : 1;
      const double y = c.coin() ? great : small_integer(c), top = c.coin() ? great : y;
      return {{{-great, std::min(y, top), 0}, {great, std::max(y, top), 1}},
              {{n, c.coin() ? -n : 1, 0}, c.one_in(3) ? -great : small_integer(c, 1)}};
    });
    add("either_zero", [](DrawStream& c) -> Question {
      const double x = zero(c), y = zero(c), z = zero(c), n = zero(c), d = zero(c), end = zero(c);
      return {{{x, y, z}, {c.coin() ? 1 : end, c.coin() ? 1 : end, 1}}, {{n, 1, n}, d}};
    });
    add("zero_normal", [](DrawStream& c) -> Question {
      const Vector3d n{0.0, zero(c), 0.0};
      return {lattice_box(c), {n, small_integer(c)}};
    });
  }

  static void repair(Question& q) { put_in_order(std::get<0>(q)); }

  static Hooks<aabb_plane> hooks() {
    return {.as_open_sets = disjoint_if_touching<Question>,
            .repair = repair,
            .scale = scale,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }

 private:
  static Vector3d lowest(const Aabb3d& box, const Vector3d& n) {
    return {n.x < 0 ? box.max.x : box.min.x, n.y < 0 ? box.max.y : box.min.y, n.z < 0 ? box.max.z : box.min.z};
  }
  /// The height of the lowest corner, in units of the length of the normal, or a few more: then the plane cuts it off.
  static Question over_plane(DrawStream& c, const Aabb3d& box, const Vector3d& n, double height) {
    const double below = c.one_in(4) ? small_integer(c) : 0.0;
    return {box, {n, height + below - dot(n, lowest(box, n))}};
  }
};

}  // namespace touchstone::catalogue::rows
