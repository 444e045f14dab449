// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/box_draws.h"
#include "catalogue/families/ties.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/sweeps/swept_aabb_aabb.h"
#include "oracle/sweeps/swept_aabb_aabb.h"
#include "reference/sweeps/swept_aabb_aabb.h"
#include "robust/sweeps/swept_aabb_aabb.h"

namespace touchstone::catalogue::rows {

struct swept_aabb_aabb : signatures::swept_aabb_aabb {
  TOUCHSTONE_STAGED_MODULES(swept_aabb_aabb)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "sweeps",
      .pages = "45-47, 51",
      .question = "When in a step does a moving axis-aligned box first meet one at rest?",
      .kind = Kind::measure,
      .fields = {"a", "b", "velocity"},
      .ulps = 2};

  static void hard_cases(HardCases<Question>& add) {
    add("head_on", [](DrawStream& c) -> Question {
      const Aabb3d a = lattice_box(c);
      const double gap = one_to(c, 8), speed = gap + small_integer(c);
      return turned(a, beside(a, overlapping(a, c), gap), {speed, 0, 0}, c);
    });
    add("corner_passes_corner", [](DrawStream& c) -> Question {
      // a reaches b on x when it leaves it on y, both at n / d.
      const Aabb3d a = lattice_box(c);
      const double d = one_to(c, 6), n = up_to(c, 5), x = one_to(c, 4), y = one_to(c, 4);
      Aabb3d b = overlapping(a, c);
      b = shifted(b, a.max.x - b.min.x + n * x, a.min.y - b.max.y + n * y, 0);
      return turned(a, b, {d * x, d * y, small_integer(c, 1)}, c);
    });
    add("enters_twice", [](DrawStream& c) -> Question {
      // On x and on y at n / d.
      const Aabb3d a = lattice_box(c);
      const double d = one_to(c, 6), n = up_to(c, 5), x = one_to(c, 4), y = one_to(c, 4);
      Aabb3d b = overlapping(a, c);
      b = shifted(b, a.max.x - b.min.x + n * x, a.max.y - b.min.y + n * y, 0);
      return turned(a, b, {d * x, d * y, 0}, c);
    });
    add("contact_at_end", [](DrawStream& c) -> Question {
      const Aabb3d a = lattice_box(c);
      const double gap = one_to(c, 8), y = small_integer(c, 1), z = small_integer(c, 1);
      return turned(a, beside(a, overlapping(a, c), gap), {gap, y, z}, c);
    });
    add("touching_at_start", [](DrawStream& c) -> Question {
      const Aabb3d a = lattice_box(c);
      const double x = small_integer(c), y = small_integer(c, 2), z = small_integer(c, 2);
      return turned(a, beside(a, overlapping(a, c), 0), {x, y, z}, c);
    });
    add("along_face", [](DrawStream& c) -> Question {
      // One side of a stays in the plane of a side of b, or just off it.
      const Aabb3d a = lattice_box(c);
      Aabb3d b = overlapping(a, c);
      const double gap = up_to(c, 5), off = small_integer(c, 1);
      b = shifted(b, a.max.x - b.min.x + gap, a.max.y - b.min.y + off, 0);
      return turned(a, b, {gap + small_integer(c, 3), 0, 0}, c);
    });
    add("at_rest", [](DrawStream& c) -> Question {
      const Aabb3d a = lattice_box(c);
      const double gap = small_integer(c, 2);
      return turned(a, beside(a, overlapping(a, c), gap), {0, 0, 0}, c);
    });
    add("flat_and_points", [](DrawStream& c) -> Question {
      const Aabb3d a = lattice_box(c);
      Aabb3d b = overlapping(a, c), flat = a;
      flat.max.x = flat.min.x;
      if (c.coin()) flat.max = flat.min;
      if (c.coin()) b.max.x = b.min.x;
      if (c.one_in(4)) b.max = b.min;
      const double gap = small_integer(c, 3), x = small_integer(c), y = small_integer(c, 1);
      return turned(flat, beside(flat, b, gap), {x, y, small_integer(c, 1)}, c);
    });
    add("one_inside", [](DrawStream& c) -> Question {
      const Aabb3d a = lattice_box(c);
      const Vector3d v{small_integer(c), small_integer(c), small_integer(c)};
      return turned(a, within(a, c), v, c);
    });
    add("rounded_corner_pass", [](DrawStream& c) -> Question {
      // As corner_passes_corner, as far as doubles can tell: t is an ordinary number, displacements are rounded.
      const double t = (1 + std::fabs(ordinary(c))) / 4, x = 1 + std::fabs(ordinary(c)), y = 1 + std::fabs(ordinary(c)),
                   d = std::ldexp(ordinary(c), -54), e = std::ldexp(ordinary(c), -54);
      const int ulps = integer_in(c, -1, 1);
      return InPlane{{{-1, e}, {d, 1}}, {{t * x, -1}, {2, moved_by_ulps(t * y, ulps)}}, {x, y}};
    });
    add("entries_nearly_equal", [](DrawStream& c) -> Question {
      const double t = std::fabs(ordinary(c)), x = 1 + std::fabs(ordinary(c)), y = 1 + std::fabs(ordinary(c));
      return InPlane{{{-1, -1}, {0, 0}}, {{t * x, t * y}, {2, 2}}, {x, y}};
    });
    add("beside_a_tie", [](DrawStream& c) -> Question {
      const auto [low, high, speed] = way_beside_tie(c);
      return InPlane{{{-0x1p60, 0}, {-low, 1}}, {{high, 0}, {0x1p90, 1}}, {speed * 0x1p54, 0}};
    });
    add("least_beside_greatest", [](DrawStream& c) -> Question {
      const double least = subnormal(c), greatest = huge(c);
      const double v = c.coin() ? greatest : 4, y = c.coin() ? least : 1, from = c.coin() ? -greatest : -4;
      return InPlane{{{from, -1}, {from, least}}, {{0, 0}, {1, 1}}, {v, y}};
    });
    add("either_zero", [](DrawStream& c) -> Question {
      const double p = zero(c), q = zero(c), r = zero(c), s = zero(c), v = c.coin() ? 1 : zero(c);
      return InPlane{{{-1, -1}, {p, q}}, {{r, s}, {1, 1}}, {v, small_integer(c, 1)}};
    });
    add("typed_shapes", [](DrawStream& c) -> Question {
      const double gap = std::fabs(catalogue::typed(c)), x = catalogue::typed(c), y = catalogue::typed(c);
      return InPlane{{{-1, -1}, {0, 0}}, {{gap, -0.3}, {gap + 1, 0.1}}, {x, y}};
    });
    add("wide", [](DrawStream& c) -> Question {
      const Vector3d by = fractions(c);
      const Aabb3d a = shifted(lattice_box(c, 12), by.x, by.y, by.z);
      const double gap = up_to(c, 7) / 4, x = gap + small_integer(c, 2), y = small_integer(c);
      const Aabb3d b = beside(a, overlapping(a, c), gap), wide = widened(a, b.max, c);
      return turned(wide, c.coin() ? widened(b, a.min, c) : b, {x, y, 0}, c);
    });
  }

  static void repair(Question& question) {
    std::visit([](auto& q) { put_in_order(std::get<0>(q)), put_in_order(std::get<1>(q)); }, question);
  }

  /// a is the square from (0, 0) to (2, 2); b's least corner, its extents, which may be 0, and the velocity run over a
  /// grid.
  static std::uint64_t domain_count(int size) { return configurations_of_digits(size, 6); }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    const double low = std::floor(size / 2.0), x = digit() - low, y = digit() - low, dx = digit(), dy = digit();
    const double u = 2 * (digit() - low), v = 2 * (digit() - low);
    return InPlane{{{0, 0}, {2, 2}}, {{2 * x, 2 * y}, {2 * x + dx, 2 * y + dy}}, {u, v}};
  }

  /// a passes the corner (4, 0) of b with its own corner, at t = 1/2: moves its velocity.
  static Question map_centre() { return InPlane{{{-4, -4}, {0, 0}}, {{4, -12}, {12, 0}}, {8, 8}}; }

  /// The step: a at its start, at the first contact and at its end; b rests.
  static void draw(Drawing& drawing, const Question& question, const FirstContact<double>& truth) {
    std::visit(
        [&](const auto& in) {
          const auto& [a, b, velocity] = in;
          draw_sweep(drawing, "a", a, velocity, truth.t);
          ::touchstone::catalogue::draw(drawing, "b", b, false);
        },
        question);
  }

  static Hooks<swept_aabb_aabb> hooks() {
    return {.as_open_sets = never_if_grazing<swept_aabb_aabb>,
            .repair = repair,
            .map_centre = map_centre,
            .draw = draw,
            .domain_count = domain_count,
            .domain_at = domain_at,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }

 private:
  /// b beyond a on x, with that gap.
  static Aabb3d beside(const Aabb3d& a, const Aabb3d& b, double gap) {
    return shifted(b, a.max.x - b.min.x + gap, 0, 0);
  }

  /// In space, or the same without z; the axes in another order, or mirrored; the boxes exchanged.
  static Question turned(Aabb3d a, Aabb3d b, Vector3d v, DrawStream& c) {
    if (c.coin()) {
      const auto next = [](auto& p) { p = {p.z, p.x, p.y}; };
      for (Aabb3d* box : {&a, &b}) next(box->min), next(box->max);
      next(v);
    }
    if (c.coin()) {
      for (Aabb3d* box : {&a, &b})
        *box = {{-box->max.x, -box->max.y, box->min.z}, {-box->min.x, -box->min.y, box->max.z}};
      v = {-v.x, -v.y, v.z};
    }
    if (c.coin()) std::swap(a, b), v = -1.0 * v;
    if (!c.coin()) return InSpace{a, b, v};
    return InPlane{without_z(a), without_z(b), {v.x, v.y}};
  }
};

}  // namespace touchstone::catalogue::rows
