// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/round_draws.h"
#include "catalogue/families/ties.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/sweeps/swept_sphere_aabb.h"
#include "oracle/sweeps/swept_sphere_aabb.h"
#include "reference/sweeps/swept_sphere_aabb.h"
#include "robust/sweeps/swept_sphere_aabb.h"

namespace touchstone::catalogue::rows {

struct swept_sphere_aabb : signatures::swept_sphere_aabb {
  TOUCHSTONE_STAGED_MODULES(swept_sphere_aabb)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "sweeps",
      .pages = "23, 45-50",
      .question = "When in a step does a moving ball first have a common point with an axis-aligned box?",
      .kind = Kind::measure,
      .fields = {"sphere", "velocity", "aabb"},
      .ulps = 26,
      .margin_degree = 2,
      .cost = 4};

  static void hard_cases(HardCases<Question>& add) {
    add("approach", [](DrawStream& c) -> Question {
      // To a face, an edge or a corner, or along it; the center is at the place after some steps of as many.
      const BeyondAabb at = beyond_aabb(c);
      const Vector3d way = c.coin() ? lattice_across(c, at.out) : inwards(c, at.out);
      const double before = up_to(c, 4), steps = one_to(c, 8), radius = reaching(c, at.length);
      return {{along(at.place, -before, way), radius}, steps * way, at.box};
    });
    add("slides_over", [](DrawStream& c) -> Question {
      // It slides towards a face or an edge, and touches it as soon as it is over it.
      const auto [box, place, out, length] = beyond_aabb(c);
      const double far = one_to(c, 8), speed = far + small_integer(c), aside = small_integer(c, 1);
      if (out.z == 0) return {{{place.x, place.y, box.min.z - far}, length}, {0, aside, speed}, box};
      return {{{box.max.x + far, place.y, place.z}, length}, {-speed, 0, aside}, box};
    });
    add("touching_at_start", [](DrawStream& c) -> Question {
      const BeyondAabb at = beyond_aabb(c);
      return {{at.place, at.length}, lattice_normal(c, 4), at.box};
    });
    add("contact_at_end", [](DrawStream& c) -> Question {
      const BeyondAabb at = beyond_aabb(c);
      const Vector3d v = inwards(c, at.out);
      return {{along(at.place, -1, v), at.length}, v, at.box};
    });
    add("nearly_flat", [](DrawStream& c) -> Question {
      BeyondAabb at = beyond_aabb(c);
      at.box.max.z = moved_by_ulps(at.box.min.z, integer_in(c, -1, 2));
      return {{at.place, reaching(c, at.length)}, inwards(c, at.out), at.box};
    });
    add("aimed", [](DrawStream& c) -> Question {
      // Over several features of a small box.
      const Point3d p = small_lattice_point(c), center{small_integer(c), small_integer(c), small_integer(c)};
      const Vector3d size{up_to(c, 3), up_to(c, 3), up_to(c, 3)};
      const Vector3d v{small_integer(c, 16), small_integer(c, 16), small_integer(c, 16)};
      return {{center, up_to(c, 4)}, v, {p, p + size}};
    });
    add("near_an_edge", [](DrawStream& c) -> Question {
      // It comes down next to an edge, or comes over it then.
      const double off = small_integer(c, 2), hair = std::ldexp(off, -integer_in(c, 0, 60)),
                   aside = small_integer(c, 2);
      return {{{hair, up_to(c, 4), 4}, 1}, {aside * hair, 0, -6}, {{-4, -4, -4}, {0, 4, 0}}};
    });
    add("beside_a_tie", [](DrawStream& c) -> Question {
      const auto [low, high, fall] = way_beside_tie(c);
      return {{{0, high, 0}, 0}, {0, -fall * 0x1p54, 0}, {{-1, -0x1p40, -1}, {1, -low, 1}}};
    });
    // Along the segment of a capsule, at times past its end; rounded where the end is no sum of its start and a double.
    add_capsules_and_aabbs([&add]<class Draw>(const char* family, const Draw&) {
      add(family, [](DrawStream& c) -> Question {
        const auto [capsule, box] = Draw()(c);
        const auto& [from, to] = capsule.segment;
        const double times = c.coin() ? 1 : 2;
        return {{from, capsule.radius}, times * (to - from), box};
      });
    });
  }

  static void repair(Question& question) {
    auto& [sphere, velocity, aabb] = question;
    sphere.radius = std::fabs(sphere.radius), put_in_order(aabb);
  }

  /// It grazes an edge by the triple 3, 4, 5; moves the center.
  static Question map_centre() { return {{{3, 11, 0}, 5}, {8, -6, 0}, {{-4, -4, -1}, {4, 4, 1}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static void draw(Drawing& drawing, const Question& question, const FirstContact<double>& truth) {
    draw_step(drawing, "sphere", "aabb", question, truth.t);
  }

  static Hooks<swept_sphere_aabb> hooks() {
    return {.as_open_sets = never_if_grazing<swept_sphere_aabb>,
            .repair = repair,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .draw = draw,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }

 private:
  /// A displacement that does not lead away from the box.
  static Vector3d inwards(DrawStream& c, const Vector3d& out) {
    const Vector3d v = lattice_normal(c, 4);
    return dot(v, out) > 0 ? -1.0 * v : v;
  }
};

}  // namespace touchstone::catalogue::rows
