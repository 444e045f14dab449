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
  TOUCHSTONE_MODULES(rigid_body_collision)
  using stages = ::touchstone::robust::stages::rigid_body_collision;
  using decision = NoDecision;

  static const Metadata& metadata() {
    static const Metadata metadata{.name = name,
                                   .chapter = "response",
                                   .pages = "74",
                                   .question = "How do two turning bodies move after they collided at a point?",
                                   .kind = Kind::measure,
                                   .fields = {"a", "b", "point", "normal", "e"},
                                   .ulps = 183,
                                   .margin_degree = 0,
                                   .cost = 7,
                                   .longest_vector = 9000};
    return metadata;
  }

  static std::vector<HardCase<Question>> hard_cases() {
    return {hard<lattice_rigid, usual>("on_lattice"),
            hard<central, usual>("central"),
            hard<resting_rigid, usual>("resting"),
            hard<ordinary_rigid, usual>("full_digits"),
            hard<thin_rigid, usual>("thin"),
            hard<unequal_rigid, at_an_end>("fly_and_wall"),
            hard<stretched_rigid, usual>("stretched_normal"),
            hard<rigid_in_far_units, at_an_end>("far_units"),
            hard<rigid_at_end_of_range, at_an_end>("at_end_of_range"),
            hard<rigid_beside_a_tie, one>("beside_a_tie"),
            hard<without_an_inertia, usual>("without_an_inertia"),
            hard<rigid_without_a_mass, usual>("without_a_mass"),
            hard<rigid_without_a_normal, usual>("without_a_normal"),
            hard<lattice_rigid, restitution_at_a_bound>("e_at_a_bound"),
            hard<planar_rigid, usual>("in_a_plane")};
  }

  /// Times in another unit: nothing else has a unit that all of the answer shares.
  static void scale(Question& question, int exponent) {
    const auto faster = [exponent](Vector3d& v) {
      v = {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
    };
    for (RigidBodyd* body : {&std::get<0>(question), &std::get<1>(question)})
      faster(body->velocity), faster(body->angular_velocity);
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
  static double usual(DrawStream& c) { return static_cast<double>(c.below(17)) / 16; }
  static double one(DrawStream&) { return 1; }
  static double at_an_end(DrawStream& c) {
    constexpr double ends[]{1, 0, -0.0, 0x1p-1074, 0x1p-30, 0x1.fffffffffffffp-1, 0x1p-900, 0.1};
    return ends[c.below(8)];
  }

  template <auto draw, auto draw_e>
  static HardCase<Question> hard(const char* name) {
    return {name, [](DrawStream& c) -> Question {
              const RigidMeeting r = draw(c);
              return {r.a, r.b, r.point, r.normal, draw_e(c)};
            }};
  }
};

}  // namespace touchstone::catalogue::rows
