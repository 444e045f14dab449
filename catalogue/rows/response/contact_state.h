// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/bodies/contact_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/response/contact_state.h"
#include "oracle/response/contact_state.h"
#include "reference/response/contact_state.h"
#include "robust/response/contact_state.h"

namespace touchstone::catalogue::rows {

struct contact_state : signatures::contact_state {
  TOUCHSTONE_STAGED_MODULES(contact_state)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "response",
      .pages = "74",
      .question = "Do two turning bodies part at the point where they touch, rest, or collide?",
      .kind = Kind::decision,
      .fields = {"a", "b", "point", "normal"},
      .answer = "state",
      .margin_degree = 2,
      .longest_vector = 6000};

  static void hard_cases(HardCases<Question>& add) {
    add("on_lattice", [](DrawStream& c) -> Question { return asked(lattice_meeting(c)); });
    add("resting", [](DrawStream& c) -> Question { return asked(resting_meeting(c)); });
    add("beside_rest", [](DrawStream& c) -> Question { return asked(meeting_beside_rest(c)); });
    add("rolling", [](DrawStream& c) -> Question { return asked(rolling(c)); });
    add("of_one_body", [](DrawStream& c) -> Question { return asked(of_one_body(c)); });
    add("terms_below_least", [](DrawStream& c) -> Question { return asked(meeting_below_least(c)); });
    add("far_units", [](DrawStream& c) -> Question { return asked(meeting_in_far_units(c)); });
    add("as_wide_as_lattices", [](DrawStream& c) -> Question { return asked(as_wide_as_lattices(c)); });
    add("across_the_range", [](DrawStream& c) -> Question { return asked(across_the_range(c)); });
    add("typed_rest", [](DrawStream& c) -> Question { return asked(typed_rest(c)); });
    add("without_a_normal", [](DrawStream& c) -> Question {
      Meeting m = lattice_meeting(c);
      m.normal = zero_vector(c);
      return asked(m);
    });
    add("in_a_plane", [](DrawStream& c) -> Question {
      const std::uint64_t which = c.below(3);
      return asked(in_a_plane(which == 0 ? lattice_meeting(c, 6) : which == 1 ? rolling(c) : typed_rest(c)));
    });
  }

  /// Angular velocities have no unit of length: they keep their values.
  static void scale(Question& question, int k) {
    auto& [a, b, p, n] = question;
    for (MovingBodyd* body : {&a, &b}) lengthen(body->position, k), lengthen(body->velocity, k);
    lengthen(p, k), lengthen(n, k);
  }

  /// A ball that rises as fast as its edge goes down: moves the velocity's y and the angular velocity's z.
  static Question map_centre() {
    return {{{0, 1, 0}, {2, 1, 0}, {0, 0, -1}}, {{0, -1, 0}, {0, 0, 0}, {0, 0, 0}}, {1, 0, 0}, {0, 1, 0}};
  }
  static std::pair<std::size_t, std::size_t> map_axes() { return {4, 8}; }

  static Hooks<contact_state> hooks() {
    return {.scale = scale, .map_centre = map_centre, .map_axes = map_axes, .laws = {.scales = true}};
  }

 private:
  static Question asked(const Meeting& m) { return {m.a, m.b, m.point, m.normal}; }
};

}  // namespace touchstone::catalogue::rows
