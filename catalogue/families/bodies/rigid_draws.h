// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/bodies/contact_draws.h"
#include "catalogue/families/bodies/impact_draws.h"

/// Two turning bodies with masses and inertias, drawn from a draw stream.
namespace touchstone::catalogue {

struct RigidMeeting {
  RigidBodyd a, b;
  Point3d point;
  Vector3d normal;
};

/// L L^T of a triangular L, of integers with a positive diagonal: positive definite, however near to not being so.
inline Inertiad lattice_inertia(DrawStream& c, int most = 4) {
  const double p = one_to(c, 8), q = one_to(c, 8), r = one_to(c, 8);
  const double s = small_integer(c, most), t = small_integer(c, most), u = small_integer(c, most);
  const double xy = p * s, xz = p * t, yz = s * t + q * u;
  return {{p * p, xy, xz}, {xy, s * s + q * q, yz}, {xz, yz, t * t + u * u + r * r}};
}
/// The inertia of a ball, or of a box along the axes.
inline Inertiad straight_inertia(DrawStream& c) {
  const double x = lattice_mass(c), y = c.coin() ? lattice_mass(c) : x, z = c.coin() ? lattice_mass(c) : x;
  return {{x, 0, 0}, {0, y, 0}, {0, 0, z}};
}
/// Full digits, and a diagonal that outweighs the rest.
inline Inertiad ordinary_inertia(DrawStream& c) {
  const Vector3d diagonal = ordinary_vector(c), beside = ordinary_vector(c);
  const auto long_enough = [](double x) { return 2 + std::fabs(x); };
  return {{long_enough(diagonal.x), beside.x, beside.y},
          {beside.x, long_enough(diagonal.y), beside.z},
          {beside.y, beside.z, long_enough(diagonal.z)}};
}

inline RigidBodyd rigid_body(double mass, const Inertiad& inertia, const MovingBodyd& moving) {
  return {mass, inertia, moving.position, moving.velocity, moving.angular_velocity};
}
template <class Draw>
RigidMeeting with_weights(DrawStream& c, const Meeting& m, const Draw& draw_inertia) {
  const Massesd masses = lattice_masses(c);
  const Inertiad a = draw_inertia(c), b = draw_inertia(c);
  return {rigid_body(masses.first, a, m.a), rigid_body(masses.second, b, m.b), m.point, m.normal};
}
inline Inertiad usual_inertia(DrawStream& c) { return c.coin() ? straight_inertia(c) : lattice_inertia(c); }

inline RigidMeeting lattice_rigid(DrawStream& c) {
  const Meeting m = lattice_meeting(c, 6);
  return with_weights(c, m, usual_inertia);
}
/// The contact is on the line of both positions along the normal: nothing begins to turn.
inline RigidMeeting central(DrawStream& c) {
  Meeting m = lattice_meeting(c, 8);
  const double s = small_integer(c), t = small_integer(c);
  m.a.position = m.point + s * m.normal, m.b.position = m.point + t * m.normal;
  return with_weights(c, m, usual_inertia);
}
inline RigidMeeting resting_rigid(DrawStream& c) {
  const Meeting m = resting_meeting(c, 6);
  return with_weights(c, m, usual_inertia);
}
inline RigidMeeting ordinary_rigid(DrawStream& c) {
  const Meeting m = of_one_body(c);
  RigidMeeting r = with_weights(c, m, ordinary_inertia);
  r.a.mass += std::fabs(ordinary(c)), r.b.velocity = ordinary_vector(c);
  return r;
}
/// As plane physics has it; three moments of inertia, of which only the last counts.
inline RigidMeeting planar_rigid(DrawStream& c) {
  const Meeting m = in_a_plane(lattice_meeting(c, 6));
  return with_weights(c, m, [](DrawStream& d) {
    const double z = lattice_mass(d), x = lattice_mass(d), y = lattice_mass(d);
    return Inertiad{{x, 0, 0}, {0, y, 0}, {0, 0, z}};
  });
}
/// Long rods, and what is nearly no body: determinants that cancel.
inline RigidMeeting thin_rigid(DrawStream& c) {
  const Meeting m = lattice_meeting(c, 6);
  const int most = 1 << (4 + c.below(20));
  return with_weights(c, m, [most](DrawStream& d) { return lattice_inertia(d, most); });
}
inline RigidMeeting unequal_rigid(DrawStream& c) {
  RigidMeeting r = lattice_rigid(c);
  const Massesd masses = unequal_masses(c);
  const auto weigh = [](RigidBodyd& body, double mass) {
    for (Vector3d* row : {&body.inertia.x, &body.inertia.y, &body.inertia.z}) *row = mass * *row;
    body.mass = mass;
  };
  weigh(r.a, masses.first), weigh(r.b, masses.second);
  return r;
}
inline RigidMeeting stretched_rigid(DrawStream& c) {
  RigidMeeting r = lattice_rigid(c);
  r.normal = stretched_normal(c);
  return r;
}
/// Masses, lengths and times in units of their own.
inline RigidMeeting rigid_in_far_units(DrawStream& c) {
  RigidMeeting r = c.coin() ? ordinary_rigid(c) : lattice_rigid(c);
  const int of_mass = integer_in(c, -200, 199), of_length = integer_in(c, -150, 149),
            of_time = integer_in(c, -200, 199);
  for (RigidBodyd* body : {&r.a, &r.b}) {
    body->mass = std::ldexp(body->mass, of_mass);
    for (Vector3d* row : {&body->inertia.x, &body->inertia.y, &body->inertia.z})
      lengthen(*row, of_mass + 2 * of_length);
    lengthen(body->position, of_length), lengthen(body->velocity, of_length - of_time);
    lengthen(body->angular_velocity, -of_time);
  }
  lengthen(r.point, of_length);
  return r;
}
inline RigidMeeting rigid_at_end_of_range(DrawStream& c) {
  RigidMeeting r = lattice_rigid(c);
  r.a.velocity = at_the_end_of_range(c);
  if (c.coin()) r.b.angular_velocity = at_the_end_of_range(c);
  return r;
}
/// At both positions the impulse only pushes; elastic.
inline RigidMeeting rigid_beside_a_tie(DrawStream& c) {
  const Impact i = impact_beside_a_tie(c);
  const Point3d p = lattice_point_in_space(c, 6);
  const MovingBodyd a{p, i.velocities.first, lattice_velocity(c, 6)}, b{p, i.velocities.second, lattice_velocity(c, 6)};
  RigidMeeting r = with_weights(c, {a, b, p, i.normal}, usual_inertia);
  r.a.mass = i.masses.first, r.b.mass = i.masses.second;
  return r;
}

/// Not positive definite, by as little as there is.
inline RigidMeeting without_an_inertia(DrawStream& c) {
  RigidMeeting r = lattice_rigid(c);
  Inertiad& i = c.coin() ? r.a.inertia : r.b.inertia;
  const double k = one_to(c, 1 << 20);
  switch (c.below(4)) {
    case 0: i = {{1, k, 0}, {k, k * k, 0}, {0, 0, 1}}; break;
    case 1: i = {{k, 0, 0}, {0, -k, 0}, {0, 0, -1}}; break;
    case 2: i = {{zero(c), 0, 0}, {0, 1, 0}, {0, 0, k}}; break;
    default: i = {{1, 1, 1}, {1, 2, 3}, {1, 3, 5}};
  }
  return r;
}
inline RigidMeeting rigid_without_a_mass(DrawStream& c) {
  RigidMeeting r = lattice_rigid(c);
  if (c.coin()) r.a.mass = zero(c);
  else r.b.mass = -r.b.mass;
  return r;
}
inline RigidMeeting rigid_without_a_normal(DrawStream& c) {
  RigidMeeting r = lattice_rigid(c);
  r.normal = zero_vector(c);
  return r;
}

/// Random bits as an inertia: symmetric, with a diagonal that outweighs the rest.
inline void make_inertia(Inertiad& i) {
  make_positive(i.x.x), make_positive(i.y.y), make_positive(i.z.z);
  const double least = std::min({i.x.x, i.y.y, i.z.z});
  const auto shorten = [least](double& x) {
    if (!(std::fabs(x) < least / 4)) x = std::copysign(least / 4, x);
  };
  shorten(i.x.y), shorten(i.x.z), shorten(i.y.z);
  i.y.x = i.x.y, i.z.x = i.x.z, i.z.y = i.y.z;
}

}  // namespace touchstone::catalogue
