// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/bodies/simultaneous_draws.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/response/simultaneous_collisions.h"
#include "oracle/response/simultaneous_collisions.h"
#include "reference/response/simultaneous_collisions.h"
#include "robust/response/simultaneous_collisions.h"

namespace touchstone::catalogue::rows {

struct simultaneous_collisions : signatures::simultaneous_collisions {
  TOUCHSTONE_MODULES(simultaneous_collisions)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "response",
      .pages = "74",
      .question = "Which velocities have bodies after all their contacts were resolved at once?",
      .kind = Kind::measure,
      .fields = {"bodies", "contacts", "e"},
      .ulps = 84,
      .margin_degree = 0,
      .cost = 11,
      .time = grows(Growth::cubic),
      .longest_vector = 6000};

  static void hard_cases(HardCases<Question>& add) {
    add("net", asked<lattice_net>);
    add("cradle", asked<cradle>);
    add("stack", asked<stack>);
    add("wedge", asked<wedge>);
    add("vice", asked<vice>);
    add("redundant", asked<redundant>);
    add("opposed", asked<opposed>);
    add("ring", asked<ring_of_contacts>);
    add("at_rest", asked<at_rest>);
    add("unequal_masses", asked<unequal>);
    add("full_digits", asked<ordinary_net>);
    add("at_the_ends", asked<stretched_net>);
    add("beside_a_tie", asked<contact_beside_a_tie>);
    add("refused", asked<refused_contacts>);
    add("in_a_plane", asked<planar_net>);
    add.unscaled("many_contacts", asked<many_contacts>);
  }

  /// e has no unit: it keeps its value.
  static void scale(Question& question, int exponent) {
    auto& [bodies, contacts, e] = question;
    for (auto& [w, v] : bodies) w = std::ldexp(w, exponent), lengthen(v, exponent);
    for (BodyContactd& contact : contacts) lengthen(contact.normal, exponent);
  }

  /// At most four bodies and three contacts: exact values of random bits grow by thousands of digits a contact.
  static void repair(Question& question) {
    auto& [bodies, contacts, e] = question;
    if (bodies.size() > 4) bodies.resize(4);
    while (bodies.size() < 2) bodies.push_back({1, {1, 0, 0}});
    if (contacts.size() > 3) contacts.resize(3);
    const auto count = static_cast<Index>(bodies.size());
    for (PointBodyd& body : bodies) body.inverse_mass = std::fabs(body.inverse_mass);
    for (auto& [a, b, n] : contacts) {
      a %= count, b %= count;
      if (a == b) b = (a + 1) % count;
      n = not_zero(n);
    }
    e = std::fabs(e);
    if (e > 1) e = 1 / e;
  }

  /// A ball in a wedge: moves the second normal's z, and e.
  static Question map_centre() {
    return {{{1, {-1, -1, 0}}, {0, {0, 0, 0}}}, {{0, 1, {0, 1, 0}}, {0, 1, {1, 1, 0}}}, 0.5};
  }

  /// The bodies in a row, whose places are not asked, with their velocities before and after; between two that touch
  /// the normal of their contact, next to each other where there are several.
  static void draw(Drawing& drawing, const Question& question, const SimultaneousVelocitiesd& truth) {
    const auto& [bodies, contacts, e] = question;
    double fastest = 0;
    for (const PointBodyd& body : bodies) fastest = std::max(fastest, largest(body.velocity));
    const double apart = fastest > 0 ? 2 * fastest : 2;
    const auto place = [&](double i) { return Point3d{apart * i, 0, 0}; };
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const std::string name = std::to_string(i);
      const Point3d at = place(static_cast<double>(i));
      catalogue::draw(drawing, name, at, false);
      drawing.notes.pop_back();
      const bool known = truth.velocities && i < truth.velocities->size();
      const Vector3d before = bodies[i].velocity, after = known ? (*truth.velocities)[i] : before;
      let_move(drawing, before, after);
      draw_arrow(drawing, name + " before", at, before, false);
      if (known) draw_arrow(drawing, name + " after", at, after, true);
    }
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const auto& [a, b, n] = contacts[i];
      const Point3d between = place((static_cast<double>(a) + static_cast<double>(b)) / 2);
      const Point3d at{between.x, -apart / 8 * static_cast<double>(i + 1), 0};
      draw_arrow(drawing, "normal " + std::to_string(a) + "-" + std::to_string(b), at, apart / 4 * unit_of(n), false);
      drawing.notes.push_back(std::to_string(a) + " and " + std::to_string(b) + " along " + in_words({n.x, n.y, n.z}));
    }
    drawing.notes.push_back("e = " + decimal(e));
  }

  /// Three bodies of inverse mass 0, 1 or 2 that move along one axis or lie still, each pair in a contact along one of
  /// four normals; e is 0, 1/2 or 1.
  static constexpr std::uint64_t masses = 3, normals = 4, restitutions = 3;
  static std::uint64_t domain_count(int size) {
    const auto n = static_cast<std::uint64_t>(size);
    return masses * masses * masses * n * n * n * normals * normals * normals * restitutions;
  }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    constexpr Vector3d along[]{{1, 0, 0}, {-1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    Question question{{}, {}, static_cast<double>(digit.next(restitutions)) / 2};
    auto& [bodies, contacts, e] = question;
    for (Index i = 0; i < 3; ++i) {
      const auto w = static_cast<double>(digit.next(masses)), x = digit();
      bodies.push_back({w, {x, 0, 0}});
      contacts.push_back({i, (i + 1) % 3, along[digit.next(normals)]});
    }
    return question;
  }

  static Hooks<simultaneous_collisions> hooks() {
    return {.repair = repair,
            .scale = scale,
            .map_centre = map_centre,
            .draw = draw,
            .domain_count = domain_count,
            .domain_at = domain_at,
            .laws = {.maps = Laws::Maps::similarities, .scales = true}};
  }

 private:
  template <auto draw>
  static Question asked(DrawStream& c) {
    Touching t = draw(c);
    return {std::move(t.bodies), std::move(t.contacts), t.e};
  }
};

}  // namespace touchstone::catalogue::rows
