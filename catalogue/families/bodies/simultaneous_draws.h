// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "catalogue/families/bodies/impact_draws.h"
#include "catalogue/families/list_draws.h"
#include "geometry/simultaneous.h"
#include "geometry/validation.h"

/// Bodies that touch, drawn from a draw stream.
namespace touchstone::catalogue {

struct Touching {
  std::vector<PointBodyd> bodies;
  std::vector<BodyContactd> contacts;
  double e;
};

/// The normal, or one that is not 0.
inline Vector3d not_zero(const Vector3d& n) {
  return validation::zero(n.x) && validation::zero(n.y) && validation::zero(n.z) ? Vector3d{1, 0, 0} : n;
}

inline double drawn_restitution(DrawStream& c) {
  if (!c.coin()) return c.coin() ? 1 : 0;
  return c.coin() ? up_to(c, 16) / 16 : 0.1 * up_to(c, 10);
}
inline double restitution_at_an_end(DrawStream& c) {
  constexpr double ends[]{1, 0, -0.0, 0x1p-1074, 0x1p-60, 0x1.fffffffffffffp-1, 0x1p-900};
  return ends[c.below(7)];
}

/// 1 or a small number; 0 one time in so many.
inline double lattice_inverse_mass(DrawStream& c, std::uint64_t immovable = 8) {
  return c.one_in(immovable) ? 0 : one_to(c, 4);
}
inline PointBodyd lattice_point_body(DrawStream& c, int bits = 6) {
  return {lattice_inverse_mass(c), lattice_velocity(c, bits)};
}

/// The same contact seen from the other body.
inline BodyContactd seen_from_b(const BodyContactd& contact) {
  const Vector3d& n = contact.normal;
  return {contact.b, contact.a, {-n.x, -n.y, -n.z}};
}
inline void mix(std::vector<BodyContactd>& contacts, DrawStream& c) {
  contacts = shuffled(std::move(contacts), c);
  for (BodyContactd& contact : contacts)
    if (c.one_in(4)) contact = seen_from_b(contact);
}

/// Three to six balls in a row, the first of which move; mostly of equal mass.
inline Touching cradle(DrawStream& c) {
  Touching t;
  const Vector3d n = lattice_normal(c, 4);
  const Index balls = 3 + static_cast<Index>(c.below(4));
  const std::uint64_t moving = 1 + c.below(2);
  const double speed = one_to(c, 64);
  const bool alike = c.below(4) != 3;
  for (Index i = 0; i < balls; ++i) {
    const double w = alike ? 1 : one_to(c, 4);
    t.bodies.push_back({w, i < moving ? speed * n : Vector3d{0, 0, 0}});
    if (i > 0) t.contacts.push_back({i, i - 1, n});
  }
  mix(t.contacts, c);
  t.e = drawn_restitution(c);
  return t;
}

/// Bodies on top of each other, on ground that nothing moves; they fall, most of them.
inline Touching stack(DrawStream& c) {
  Touching t;
  const Vector3d n = axis_normal(c);
  const Index height = 1 + static_cast<Index>(c.below(5));
  t.bodies.push_back({0, {0, 0, 0}});
  for (Index i = 1; i <= height; ++i) {
    const double w = one_to(c, 4), speed = -up_to(c, 7);
    const Vector3d aside = c.one_in(4) ? lattice_across(c, n) : Vector3d{0, 0, 0};
    t.bodies.push_back({w, speed * n + aside});
    t.contacts.push_back({i, i - 1, n});
  }
  mix(t.contacts, c);
  t.e = drawn_restitution(c);
  return t;
}

/// A ball between walls, two to four of them, that stand still or move; some of them nearly catch it, or do.
inline Touching wedge(DrawStream& c) {
  Touching t;
  const double w = one_to(c, 4);
  t.bodies.push_back({w, lattice_velocity(c, 6)});
  const Index walls = 2 + static_cast<Index>(c.below(3));
  for (Index i = 1; i <= walls; ++i) {
    t.bodies.push_back({0, c.coin() ? lattice_velocity(c, 3) : zero_vector(c)});
    t.contacts.push_back({0, i, lattice_normal(c, 3)});
  }
  mix(t.contacts, c);
  t.e = drawn_restitution(c);
  return t;
}

/// Two walls that face each other and a ball, or two, between them: caught where the walls close.
inline Touching vice(DrawStream& c) {
  const Vector3d n = lattice_normal(c, 3);
  const double left = small_integer(c, 2), right = small_integer(c, 2), ball = small_integer(c, 3);
  Touching t{{{0, left * n}, {1, ball * n}}, {{1, 0, n}}, 0};
  if (c.coin()) t.bodies.push_back({2, small_integer(c, 3) * n}), t.contacts.push_back({2, 1, n});
  t.bodies.push_back({0, right * n});
  const auto last = static_cast<Index>(t.bodies.size() - 1);
  t.contacts.push_back({last, last - 1, n});
  if (c.one_in(4)) t.contacts.push_back({last, 0, n});  // of the walls alone
  mix(t.contacts, c);
  t.e = drawn_restitution(c);
  return t;
}

/// Any bodies and contacts, of small integers.
inline Touching lattice_net(DrawStream& c) {
  Touching t;
  const std::uint64_t bodies = 2 + c.below(5);
  while (t.bodies.size() < bodies) t.bodies.push_back(lattice_point_body(c, 4));
  while (t.contacts.size() < 8 && c.below(8) != 7) {
    const std::uint64_t a = c.below(bodies), further = 1 + c.below(bodies - 1);
    t.contacts.push_back({static_cast<Index>(a), static_cast<Index>((a + further) % bodies), lattice_normal(c, 2)});
  }
  t.e = drawn_restitution(c);
  return t;
}

/// Contacts that say again what others say, or less, or with a longer normal: of a wedge, a cradle or a net.
inline Touching redundant(DrawStream& c) {
  const std::uint64_t which = c.below(3);
  Touching t = which == 0 ? cradle(c) : which == 1 ? wedge(c) : stack(c);
  const std::size_t several = t.contacts.size();
  while (t.contacts.size() < 8 && c.below(4) != 3) {
    BodyContactd one = t.contacts[c.below(several)];
    const BodyContactd& other = t.contacts[c.below(several)];
    if (c.coin()) one.normal = one_to(c, 3) * one.normal;
    else if (one.a == other.a) one.normal = one.normal + other.normal;  // a demand between both
    one.normal = not_zero(one.normal);
    t.contacts.push_back(one);
  }
  mix(t.contacts, c);
  return t;
}

/// Two bodies, and contacts with opposite normals: no bounce is possible, and e = 0 just so.
inline Touching opposed(DrawStream& c) {
  const Vector3d n = lattice_normal(c, 4);
  const PointBodyd a = lattice_point_body(c, 3), b = lattice_point_body(c, 3);
  const double back = -one_to(c, 3), e = c.coin() ? drawn_restitution(c) : 0;
  Touching t{{a, b}, {{0, 1, n}, {0, 1, back * n}}, e};
  if (c.coin()) t.contacts.push_back({0, 1, lattice_normal(c, 2)});
  mix(t.contacts, c);
  return t;
}

/// A ring of bodies whose normals add up to nothing.
inline Touching ring_of_contacts(DrawStream& c) {
  Touching t;
  const Index bodies = 3 + static_cast<Index>(c.below(2));
  Vector3d sum{0, 0, 0};
  for (Index i = 0; i < bodies; ++i) {
    t.bodies.push_back(lattice_point_body(c, 3));
    const Vector3d n = i + 1 < bodies ? lattice_normal(c, 2) : Vector3d{-sum.x, -sum.y, -sum.z};
    sum = sum + n;
    t.contacts.push_back({i, (i + 1) % bodies, not_zero(n)});
  }
  t.e = c.coin() ? drawn_restitution(c) : 0;
  return t;
}

/// Velocities that are the same, or nearly: contacts at rest, and some that part or approach by a few
/// units in the last place.
inline Touching at_rest(DrawStream& c) {
  Touching t = c.coin() ? lattice_net(c) : stack(c);
  const Vector3d v = ordinary_vector(c);
  for (PointBodyd& body : t.bodies) {
    const double x = ulps_apart(c, v.x, 2);
    body.velocity = {x, v.y, v.z};
  }
  return t;
}

/// The numbers of another family, with the inverse mass of each body as many times as great, or less.
inline Touching unequal(DrawStream& c) {
  Touching t = c.coin() ? cradle(c) : stack(c);
  constexpr int ratios[]{0, 40, -53, 107, -400, 900};
  for (PointBodyd& body : t.bodies) body.inverse_mass = std::ldexp(body.inverse_mass, ratios[c.below(6)]);
  return t;
}

/// Full digits.
inline Touching ordinary_net(DrawStream& c) {
  Touching t = lattice_net(c);
  for (auto& [w, v] : t.bodies) {
    if (w != 0) w = 1 + std::fabs(ordinary(c));
    v = ordinary_vector(c);
  }
  if (t.contacts.size() > 4) t.contacts.resize(4);
  for (BodyContactd& contact : t.contacts) contact.normal = not_zero(ordinary_vector(c));
  return t;
}

/// At the ends of the range: normals and velocities there, and an e near 0 or 1.
inline Touching stretched_net(DrawStream& c) {
  Touching t = c.coin() ? wedge(c) : cradle(c);
  if (t.contacts.size() > 4) t.contacts.resize(4);
  const std::uint64_t which = c.below(4);
  for (BodyContactd& contact : t.contacts)
    if (which != 1) contact.normal = stretched_normal(c);
  for (PointBodyd& body : t.bodies)
    if (which == 1 || which == 2) body.velocity = at_the_end_of_range(c);
  if (which == 3)
    for (PointBodyd& body : t.bodies) body.velocity = at_the_end_of_products(c);
  t.e = restitution_at_an_end(c);
  return t;
}

/// As impact_beside_a_tie: only the ratio of the inverse masses counts.
inline Touching contact_beside_a_tie(DrawStream& c) {
  const Impact i = impact_beside_a_tie(c);
  Touching t{{{i.masses.second, i.velocities.first}, {i.masses.first, i.velocities.second}}, {{1, 0, i.normal}}, 1};
  if (c.coin()) t.contacts[0] = {1, 0, {-1, 0, 0}};
  if (c.coin()) {
    t.bodies.push_back({1, {0, 0, 0}});
    t.contacts.push_back({2, 1, {0, 1, 0}});
  }
  return t;
}

/// A row of balls of one mass, of which the first move; or pairs of balls, each for itself. As long as exact numbers
/// stay short.
inline Touching many_contacts(DrawStream& c) {
  Touching t;
  const Vector3d n = lattice_normal(c, 2);
  const Index step = c.coin() ? 2 : 1;
  const std::uint64_t moving = 1 + c.below(2);
  std::uint64_t place = 0;
  const auto ball = [&](DrawStream& d) {
    const double speed = place++ < moving ? 8 : -up_to(d, 1);
    return PointBodyd{1, speed * n};
  };
  t.bodies = long_list(c, ball, 70);
  for (Index i = 1; i < t.bodies.size(); i += step) t.contacts.push_back({i, i - 1, n});
  t.e = c.coin() ? 0 : 1;
  return t;
}

/// As plane physics has it: all in the plane z = 0.
inline Touching planar_net(DrawStream& c) {
  Touching t = c.coin() ? wedge(c) : lattice_net(c);
  if (t.contacts.size() > 4) t.contacts.resize(4);
  for (PointBodyd& body : t.bodies) body.velocity.z = 0;
  for (BodyContactd& contact : t.contacts) contact.normal.z = 0, contact.normal = not_zero(contact.normal);
  return t;
}

/// Something that is refused, somewhere.
inline Touching refused_contacts(DrawStream& c) {
  Touching t = lattice_net(c);
  const auto bodies = static_cast<Index>(t.bodies.size());
  if (t.contacts.empty()) t.contacts.push_back({0, 1, {1, 0, 0}});
  BodyContactd& contact = t.contacts[c.below(t.contacts.size())];
  switch (c.below(6)) {
    case 0: contact.normal = zero_vector(c); break;
    case 1: contact.b = contact.a; break;
    case 2: contact.a = bodies + static_cast<Index>(c.below(2)); break;
    case 3: contact.b = bodies; break;
    case 4: t.bodies[c.below(bodies)].inverse_mass = c.coin() ? -0x1p-1074 : -1; break;
    default: t.e = c.coin() ? -0x1p-1074 : 0x1.0000000000001p0;
  }
  return t;
}

}  // namespace touchstone::catalogue
