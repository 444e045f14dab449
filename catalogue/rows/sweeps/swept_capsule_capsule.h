// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/passages/capsule_pairs.h"
#include "catalogue/families/ties.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/sweeps/swept_capsule_capsule.h"
#include "oracle/sweeps/swept_capsule_capsule.h"
#include "reference/sweeps/swept_capsule_capsule.h"
#include "robust/sweeps/swept_capsule_capsule.h"

namespace touchstone::catalogue::rows {

struct swept_capsule_capsule : signatures::swept_capsule_capsule {
  TOUCHSTONE_STAGED_MODULES(swept_capsule_capsule)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "sweeps",
      .pages = "23, 51",
      .question = "When in a step does a moving capsule first have a common point with one at rest?",
      .kind = Kind::measure,
      .fields = {"a", "b", "velocity"},
      .ulps = 63,
      .margin_degree = 2,
      .cost = 6};

  static void hard_cases(HardCases<Question>& add) {
    add("slides_along", [](DrawStream& c) -> Question {
      // On parallel planes, as far from each other as both radii, over or past b.
      const IntegerAcross across = IntegerAcross::of(c);
      const Point3d p = lattice_point_in_space(c, 16);
      const auto [r, s] = reaching_radii(c, across.length);
      const Segment3d first = segment_through(c, p + across.displacement, across.u);
      const double i = small_integer(c, 4), j = small_integer(c, 4);
      return {{first, r}, {segment_through(c, p, across.v), s}, i * across.u + j * across.v};
    });
    add("crosses", [](DrawStream& c) -> Question {
      // One segment goes through the other, all ends being farther away than both radii.
      const LatticePlane plane = LatticePlane::of(c, 4);
      const double back = one_to(c, 9), far = up_to(c, 18), r = up_to(c, 1), s = up_to(c, 1);
      const Vector3d n = cross(plane.u, plane.v);
      const Point3d from = along(plane.origin, -back, n);
      const Segment3d across{along(from, -8, plane.u), along(from, 8, plane.u)};
      return {{across, r}, {{plane.at(0, -8), plane.at(0, 8)}, s}, far * n};
    });
    add("end_on", [](DrawStream& c) -> Question {
      // On one line, of which the first leads along it or across it.
      const Step step = integer_step(c);
      const Point3d p = lattice_point_in_space(c, 16);
      const Vector3d& v = step.displacement;
      const double i = one_to(c, 4), length = up_to(c, 3), far = up_to(c, 4);
      const auto [r, s] = reaching_radii(c, step.length);
      const Vector3d u = c.coin() ? v : lattice_across(c, v);
      return {{{p, along(p, -length, u)}, r}, {{along(p, i, v), along(p, i + up_to(c, 3), v)}, s}, far * v};
    });
    add("beside_a_tie", [](DrawStream& c) -> Question {
      const auto [low, high, fall] = way_beside_tie(c);
      return {{{{-4, high, 0}, {4, high, 0}}, 0}, {{{0, -low, -4}, {0, -low, 4}}, 0}, {0, -fall * 0x1p54, 0}};
    });
    // Before, after or at the place of a next to b.
    add_pairs_of_capsules([&add]<class Draw>(const char* family, const Draw&) {
      add(family, [](DrawStream& c) -> Question {
        const auto [a, b] = Draw()(c);
        const Vector3d way = lattice_normal(c, 4);
        const double before = up_to(c, 2), steps = up_to(c, 3);
        return {moved(a, -before * way), b, steps * way};
      });
    });
  }

  /// It grazes the end (4, 4, 0) by the triple 3, 4, 5; moves the nearer end.
  static Question map_centre() { return {{{{3, 11, 0}, {3, 17, 0}}, 3}, {{{4, 4, 0}, {-4, -4, 1}}, 2}, {8, -6, 0}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  /// The step: a at its start, at the first contact and at its end.
  static void draw(Drawing& drawing, const Question& question, const FirstContact<double>& truth) {
    const auto& [a, b, velocity] = question;
    draw_sweep(drawing, "a", a, velocity, truth.t);
    ::touchstone::catalogue::draw(drawing, "b", b, false);
  }

  static Hooks<swept_capsule_capsule> hooks() {
    return {.as_open_sets = never_if_grazing<swept_capsule_capsule>,
            .repair = repair_radii<Question>,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .draw = draw,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
