// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/bodies/rigid_draws.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/response/rigid_body_collision.h"
#include "oracle/response/rigid_body_collision.h"
#include "reference/response/rigid_body_collision.h"
#include "robust/response/rigid_body_collision.h"

namespace touchstone::catalogue::rows {

struct rigid_body_collision : signatures::rigid_body_collision {
  TOUCHSTONE_STAGED_MODULES(rigid_body_collision)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "response",
                                     .pages = "74",
                                     .question = "How do two turning bodies move after they collided at a point?",
                                     .kind = Kind::measure,
                                     .fields = {"a", "b", "point", "normal", "e"},
                                     .ulps = 183,
                                     .margin_degree = 0,
                                     .cost = 7,
                                     .longest_vector = 9000};

  static void hard_cases(HardCases<Question>& add) {
    add("on_lattice", asked<lattice_rigid, usual>);
    add("central", asked<central, usual>);
    add("resting", asked<resting_rigid, usual>);
    add("full_digits", asked<ordinary_rigid, usual>);
    add("thin", asked<thin_rigid, usual>);
    add("fly_and_wall", asked<unequal_rigid, at_an_end>);
    add("stretched_normal", asked<stretched_rigid, usual>);
    add("far_units", asked<rigid_in_far_units, at_an_end>);
    add("at_end_of_range", asked<rigid_at_end_of_range, at_an_end>);
    add("beside_a_tie", asked<rigid_beside_a_tie, one>);
    add("without_an_inertia", asked<without_an_inertia, usual>);
    add("without_a_mass", asked<rigid_without_a_mass, usual>);
    add("without_a_normal", asked<rigid_without_a_normal, usual>);
    add("e_at_a_bound", asked<lattice_rigid, restitution_at_a_bound>);
    add("in_a_plane", asked<planar_rigid, usual>);
  }

  /// Times in another unit: nothing else has a unit that all of the answer shares.
  static void scale(Question& question, int exponent) {
    for (RigidBodyd* body : {&std::get<0>(question), &std::get<1>(question)})
      lengthen(body->velocity, exponent), lengthen(body->angular_velocity, exponent);
  }

  static void repair(Question& question) {
    auto& [a, b, p, n, e] = question;
    for (RigidBodyd* body : {&a, &b}) make_positive(body->mass), make_inertia(body->inertia);
    e = std::fabs(e);
    if (e > 1) e = 1 / e;
  }

  /// A rod that is struck at its end: moves the contact's x and the normal's z.
  static Question map_centre() {
    const Inertiad rod{{1, 0, 0}, {0, 4, 0}, {0, 0, 4}};
    return {{3, rod, {0, 0, 0}, {0, -1, 0}, {0, 0, 0}},
            {1, rod, {4, -1, 0}, {0, 0, 0}, {0, 0, 1}},
            {2, 0, 0},
            {0, 1, 0},
            0.5};
  }
  static std::pair<std::size_t, std::size_t> map_axes() { return {38, 43}; }

  /// Two bodies of one mass, one of them tilted, and nine numbers that change. All others are such that they are valid
  /// where the grid begins at -1, too.
  static std::uint64_t domain_count(int size) { return configurations_of_digits(size, 9); }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    const double xy = digit();
    RigidBodyd a{2, {{4, xy, 0}, {xy, 4, 0}, {0, 0, 4}}, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
    const RigidBodyd b{2, {{4, 0, 0}, {0, 4, 0}, {0, 0, 4}}, {1, 1, 1}, {1, 0, 1}, {1, 1, 0}};
    Vector3d n{};
    for (double* x : {&a.position.x, &a.position.y, &a.velocity.y, &a.angular_velocity.z, &n.x, &n.y, &n.z})
      *x = digit();
    return {a, b, {digit(), 1, 1}, n, 1};
  }

  /// Each body at its position with its motion before and after, and the normal at the point of contact.
  static void draw(Drawing& drawing, const Question& question, const Motions<double>& truth) {
    const auto& [a, b, point, normal, e] = question;
    const auto body = [&drawing](const std::string& name, const RigidBodyd& before, const Motion<double>& after) {
      catalogue::draw(drawing, name, before.position, false);
      let_move(drawing, before.velocity, after.velocity);
      draw_arrow(drawing, name + " before", before.position, before.velocity, false);
      draw_arrow(drawing, name + " turns before", before.position, before.angular_velocity, false);
      draw_arrow(drawing, name + " after", before.position, after.velocity, true);
      draw_arrow(drawing, name + " turns after", before.position, after.angular_velocity, true);
    };
    body("a", a, truth.a), body("b", b, truth.b);
    catalogue::draw(drawing, "point", point, false);
    draw_arrow(drawing, "normal", point, normal, false);
    drawing.notes.push_back("e = " + decimal(e));
  }

  static Hooks<rigid_body_collision> hooks() {
    return {.repair = repair,
            .scale = scale,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .draw = draw,
            .domain_count = domain_count,
            .domain_at = domain_at,
            .laws = {.scales = true}};
  }

 private:
  static double usual(DrawStream& c) { return up_to(c, 16) / 16; }
  static double one(DrawStream&) { return 1; }
  static double at_an_end(DrawStream& c) {
    constexpr double ends[]{1, 0, -0.0, 0x1p-1074, 0x1p-30, 0x1.fffffffffffffp-1, 0x1p-900, 0.1};
    return ends[c.below(8)];
  }

  template <auto draw, auto draw_e>
  static Question asked(DrawStream& c) {
    const RigidMeeting r = draw(c);
    return {r.a, r.b, r.point, r.normal, draw_e(c)};
  }
};

}  // namespace touchstone::catalogue::rows
