// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/bodies/bounce_draws.h"
#include "geometry/bodies.h"

/// Two turning bodies that touch, drawn from a draw stream.
namespace touchstone::catalogue {

struct Meeting {
  MovingBodyd a, b;
  Point3d point;
  Vector3d normal;
};

/// The velocity of the point of the body; exact on small lattices.
inline Vector3d going(const MovingBodyd& body, const Point3d& point) {
  return body.velocity + cross(body.angular_velocity, point - body.position);
}

inline MovingBodyd lattice_moving_body(DrawStream& c, int bits) {
  return {lattice_point_in_space(c, bits), lattice_velocity(c, bits), lattice_velocity(c, bits)};
}
inline Meeting lattice_meeting(DrawStream& c, int bits = 12) {
  const MovingBodyd a = lattice_moving_body(c, bits), b = lattice_moving_body(c, bits);
  return {a, b, lattice_point_in_space(c, bits), lattice_normal(c, bits)};
}

/// As plane physics has it: all in the plane z = 0, turns about z.
inline Meeting in_a_plane(Meeting m) {
  for (MovingBodyd* body : {&m.a, &m.b}) {
    body->position.z = body->velocity.z = 0;
    body->angular_velocity = {0, 0, body->angular_velocity.z};
  }
  m.point.z = 0;
  const Vector3d& n = m.normal;
  m.normal = n.x == 0 && n.y == 0 ? Vector3d{0, 1, 0} : Vector3d{n.x, n.y, 0};
  return m;
}

/// They slide along each other, at most.
inline Meeting resting_meeting(DrawStream& c, int bits = 12) {
  Meeting m = lattice_meeting(c, bits);
  const Vector3d sliding = lattice_across(c, m.normal);
  m.a.velocity = m.a.velocity + (going(m.b, m.point) - going(m.a, m.point)) + sliding;
  return m;
}
/// The same but for the least step, if any, below the digits of the products.
inline Meeting meeting_beside_rest(DrawStream& c) {
  Meeting m = resting_meeting(c, 20);
  const double x = small_integer(c, 1), y = small_integer(c, 1);
  m.a.velocity = m.a.velocity + Vector3d{x, y, 0};
  return m;
}

/// A ball on the ground, which turns as it moves or slips.
inline Meeting rolling(DrawStream& c) {
  const double radius = one_to(c, 16);
  const Point3d p = lattice_point_in_space(c, 12), below = lattice_point_in_space(c, 12);
  MovingBodyd ball{{p.x, p.y + radius, p.z}, {0, 0, 0}, lattice_velocity(c, 12)};
  ball.velocity = -1.0 * cross(ball.angular_velocity, p - ball.position);
  ball.velocity.x += small_integer(c, 2), ball.velocity.y += small_integer(c, 1);
  return {ball, {below, zero_vector(c), zero_vector(c)}, p, {0, one_to(c, 4), 0}};
}

/// Two places of one turning body, full digits: but for rounding they rest.
inline Meeting of_one_body(DrawStream& c) {
  const auto place = [&c] {
    const Vector3d v = ordinary_vector(c);
    return Point3d{v.x, v.y, v.z};
  };
  const Vector3d turn = ordinary_vector(c), v = ordinary_vector(c);
  const Point3d x = place(), y = place(), p = place();
  const MovingBodyd a{x, v, turn};
  return {a, {y, going(a, y), turn}, p, c.coin() ? ordinary_vector(c) : lattice_normal(c, 4)};
}

/// Angular velocities, places and the normal in other units, each a power of two.
inline Meeting in_units(Meeting m, int of_turn, int of_place, int of_normal) {
  for (MovingBodyd* body : {&m.a, &m.b}) {
    lengthen(body->position, of_place), lengthen(body->velocity, of_turn + of_place);
    lengthen(body->angular_velocity, of_turn);
  }
  lengthen(m.point, of_place), lengthen(m.normal, of_normal);
  return m;
}
/// Products of three are a few times the least number, or less.
inline Meeting meeting_below_least(DrawStream& c) {
  const Meeting m = c.coin() ? lattice_meeting(c, 4) : resting_meeting(c, 4);
  const int of_turn = -340 - integer_in(c, 0, 19), of_place = -350 - integer_in(c, 0, 19);
  return in_units(m, of_turn, of_place, -360 - integer_in(c, 0, 19));
}
/// Units from one end of the range to the other.
inline Meeting meeting_in_far_units(DrawStream& c) {
  const Meeting m = c.coin() ? lattice_meeting(c) : resting_meeting(c);
  const int of_turn = integer_in(c, -450, 449), of_place = integer_in(c, -450, 449);
  return in_units(m, of_turn, of_place, integer_in(c, -900, 899));
}

/// The turning part has nearly 125 binary digits and cancels the rest, as far as that has digits.
inline Meeting as_wide_as_lattices(DrawStream& c) {
  const auto long_number = [&c] {
    const double less = one_to(c, 64);
    return 0x1p61 - std::ldexp(less, integer_in(c, 8, 53));
  };
  const double turn = long_number(), place = long_number(), v = 8 * turn * place;
  const Point3d x{place, place, place};
  const MovingBodyd a{x, {v, 0, 0}, {1, turn, -turn}}, b{x, {0, 0, 0}, {1, -turn, turn}};
  return {a, b, {1, -place, -place}, {either_sign(c), small_integer(c, 1), 0}};
}

/// The way from a to the contact is beyond the range.
inline Meeting across_the_range(DrawStream& c) {
  const double far = std::ldexp(static_cast<double>(4 + c.below(4)), 1021), k = one_to(c, 8);
  const double slow = std::ldexp(k, -1040), beside = small_integer(c, 1);
  const MovingBodyd a{{-far, 0, 0}, {0, -far * (2 * slow) + beside, 0}, {0, 0, slow}};
  return {a, {{0, 0, 0}, zero_vector(c), zero_vector(c)}, {far, 0, 0}, {0, 1, 0}};
}

/// As typed they rest: a tenth times a tenth is a hundredth.
inline Meeting typed_rest(DrawStream& c) {
  const double k = one_to(c, 9), m = one_to(c, 9);
  const MovingBodyd a{{0, 0, 0}, {k * m / 100, 0, 0}, {0, 0, k / 10}};
  return {a, {{0, 1, 0}, {0, 0, 0}, {0, 0, 0}}, {0, m / 10, 0}, {1, 0, 0}};
}

}  // namespace touchstone::catalogue
