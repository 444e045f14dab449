// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "catalogue/families/bodies/simultaneous_draws.h"
#include "geometry/steps.h"

/// Balls and walls before a step, drawn from a draw stream: mostly by where they are to be at its end.
namespace touchstone::catalogue {

struct Stepping {
  std::vector<StepBodyd> bodies;
  std::vector<Plane3d> walls;
  StepSettingsd settings;

  /// The ball that flies to `end` and starts with that velocity; without a velocity if it never moves.
  void add(const Point3d& end, double radius, double inverse_mass, const Vector3d& velocity) {
    if (validation::zero(inverse_mass)) return bodies.push_back({inverse_mass, {0, 0, 0}, {end, radius}});
    const double h = settings.timestep;
    const double share = settings.motion == StepMotion::accelerate_then_move ? 1
                         : settings.motion == StepMotion::parabola           ? 0.5
                                                                             : 0;
    const Vector3d back = -h * (velocity + (h * share) * settings.gravity);
    bodies.push_back({inverse_mass, velocity, {end + back, radius}});
  }
};

/// With a timestep and gravity of few digits.
inline Stepping empty_stepping(DrawStream& c) {
  constexpr StepMotion motions[]{StepMotion::accelerate_then_move, StepMotion::move_then_accelerate,
                                 StepMotion::parabola};
  constexpr double timesteps[]{1, 0.5, 0.25, 2, 0x1p-6};
  const double pull = c.coin() ? -2 * up_to(c, 5) : 0.0;
  const StepMotion motion = motions[c.below(3)];
  const StepTurn turn = c.coin() ? StepTurn::after_move : StepTurn::before_move;
  const double h = timesteps[c.below(5)];
  return {{}, {}, {{0, pull, 0}, motion, drawn_restitution(c), h, turn}};
}

/// Balls of which some meet at the end, of small integers; perhaps walls.
inline Stepping lattice_balls(DrawStream& c) {
  Stepping s = empty_stepping(c);
  const std::uint64_t count = 1 + c.below(5);
  while (s.bodies.size() < count) {
    const double x = small_integer(c, 3), y = small_integer(c, 3), z = small_integer(c, 1);
    const double radius = up_to(c, 3), w = lattice_inverse_mass(c);
    s.add({x, y, z}, radius, w, lattice_velocity(c, 3));
  }
  while (s.walls.size() < 3 && c.one_in(3)) {
    const Vector3d n = lattice_normal(c, 2);
    s.walls.push_back({n, small_integer(c, 6)});
  }
  return s;
}

/// Two balls that touch at the end, just so, along a direction of whole length; or are an ulp apart.
inline Stepping tangent_balls(DrawStream& c) {
  Stepping s = empty_stepping(c);
  const IntegerNormal direction = integer_normal(c);
  const double part = up_to(c, 8) / 8, times = one_to(c, 4);
  const double x = integer(c, 8), y = integer(c, 8), w = lattice_inverse_mass(c), other = 1 + lattice_inverse_mass(c);
  const double length = times * direction.length, radius = part * length, reach = ulps_apart(c, length - radius, 1);
  const Vector3d v = lattice_velocity(c, 4), u = lattice_velocity(c, 4);
  const Point3d at{x, y, 0};
  s.add(at, radius, w, v);
  s.add(at + times * direction.n, std::fabs(reach), other, c.one_in(4) ? v : u);
  return s;
}

/// Balls in a row, each of which touches the next, and of which the first move: perhaps towards a wall at the end.
inline Stepping row_of_balls(DrawStream& c) {
  Stepping s = empty_stepping(c);
  s.settings.gravity = {0, 0, 0};
  const auto [n, length] = integer_normal(c);
  const std::uint64_t balls = 2 + c.below(5), moving = 1 + c.below(2);
  const double speed = one_to(c, 16);
  const bool alike = c.below(4) != 3;
  for (std::uint64_t i = 0; i < balls; ++i) {
    const double w = alike ? 1 : one_to(c, 4);
    s.add(Point3d{0, 0, 0} + static_cast<double>(i) * n, length / 2, w, i < moving ? speed * n : Vector3d{0, 0, 0});
  }
  // The last center's height over the wall is its radius.
  const double beyond = (static_cast<double>(balls) - 0.5) * length * length;
  if (c.coin()) s.walls.push_back({-1.0 * n, beyond});
  s.bodies = shuffled(std::move(s.bodies), c);
  return s;
}

/// Balls on top of each other, on the ground, which fall or lie there.
inline Stepping stacked_balls(DrawStream& c) {
  Stepping s = empty_stepping(c);
  const std::uint64_t height = 1 + c.below(5);
  const double fall = -up_to(c, 3);
  double top = 0;
  for (std::uint64_t i = 0; i < height; ++i) {
    const double radius = one_to(c, 3), w = one_to(c, 3);
    const double aside = c.one_in(4) ? small_integer(c, 2) : 0.0;
    s.add({0, top + radius, 0}, radius, w, {aside, fall, 0});
    top += 2 * radius;
  }
  const double stretch = one_to(c, 4);
  if (c.below(8) != 7) s.walls.push_back({{0, stretch, 0}, 0});
  s.bodies = shuffled(std::move(s.bodies), c);
  return s;
}

/// A ball among walls, two to four, that it touches at the end, or nearly; some of them face each other.
inline Stepping ball_in_a_corner(DrawStream& c) {
  Stepping s = empty_stepping(c);
  const double x = integer(c, 6), y = integer(c, 6), z = integer(c, 6), radius = up_to(c, 4);
  const Vector3d v = lattice_velocity(c, 5);
  s.add({x, y, z}, radius, 1 + lattice_inverse_mass(c), v);
  const std::uint64_t walls = 2 + c.below(3);
  while (s.walls.size() < walls) {
    const IntegerNormal wall = integer_normal(c);
    const double side = either_sign(c);
    const Vector3d n = side * wall.n;
    const double offset = radius * wall.length - dot(n, Vector3d{x, y, z});
    s.walls.push_back({n, ulps_apart(c, offset, 1)});
  }
  return s;
}

/// Balls that overlap at the start and at the end, approach, part, or are at rest; centers coincide, or nearly.
inline Stepping overlapping_balls(DrawStream& c) {
  Stepping s = empty_stepping(c);
  const std::uint64_t count = 2 + c.below(2);
  const double x = integer(c, 10), y = integer(c, 10), radius = up_to(c, 3);
  const Vector3d v = lattice_velocity(c, 3);
  for (std::uint64_t i = 0; i < count; ++i) {
    const double aside = c.coin() ? ulps_apart(c, x, 2) : x;
    const double w = lattice_inverse_mass(c), up = small_integer(c, 1);
    s.add({aside, y, 0}, radius, w, {v.x, v.y + up, v.z});
  }
  return s;
}

/// Balls that never move, and one that hits several of them; perhaps they meet each other.
inline Stepping immovable_balls(DrawStream& c) {
  Stepping s = empty_stepping(c);
  const std::uint64_t count = 1 + c.below(4);
  const Vector3d v = lattice_velocity(c, 4);
  s.add({0, 0, 0}, 2, 1 + lattice_inverse_mass(c), v);
  constexpr Point3d places[]{{3, 4, 0}, {-3, 4, 0}, {0, 0, 5}, {0, 5, 0}, {0, -3, 4}};
  for (std::uint64_t i = 0; i < count; ++i) {
    const Point3d at = places[c.below(5)];
    const double radius = 3 + up_to(c, 1);
    s.add(at, radius, zero(c), {});
  }
  return s;
}

/// Particles: on a wall, behind it, on a ball; with each other they never meet.
inline Stepping particles(DrawStream& c) {
  Stepping s = empty_stepping(c);
  const Vector3d n = lattice_normal(c, 4);
  const std::uint64_t count = 1 + c.below(4);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Vector3d across = lattice_across(c, n), v = lattice_velocity(c, 4);
    const Point3d on = Point3d{0, 0, 0} + (c.coin() ? across : Vector3d{0, 0, 0});
    const double beyond = small_integer(c, 1), w = lattice_inverse_mass(c);
    s.add(on + beyond * n, zero(c), w, v);
  }
  s.walls.push_back({n, zero(c)});
  if (c.coin()) s.add({0, 5, 0}, 5, 1, lattice_velocity(c, 4));
  return s;
}

/// Relative velocities that are 0 along the normal, or nearly: what slides along a wall or another ball.
inline Stepping sliding_balls(DrawStream& c) {
  Stepping s = empty_stepping(c);
  const auto [n, length] = integer_normal(c);
  const Vector3d across = lattice_across(c, n), further = lattice_across(c, n);
  const double along = small_integer(c, 1), radius = length * one_to(c, 3);
  s.settings.gravity = {0, 0, 0};
  s.add(Point3d{0, 0, 0}, radius, 1 + lattice_inverse_mass(c), across + along * n);
  s.walls.push_back({n, length * radius});
  if (c.coin()) s.add(Point3d{0, 0, 0} + (2 * radius / length) * n, radius, lattice_inverse_mass(c), further);
  const double x = s.bodies[0].velocity.x;
  s.bodies[0].velocity.x = ulps_apart(c, x, 1);
  return s;
}

/// Fast bodies, which pass through what they do not meet at the end.
inline Stepping bullets(DrawStream& c) {
  Stepping s = empty_stepping(c);
  const double fast = scaled_up(c, 16, 20);
  const Vector3d n = lattice_normal(c, 2);
  const double past = small_integer(c, 2);
  s.add(Point3d{0, 0, 0} + past * n, up_to(c, 1), 1, fast * n);
  const double w = lattice_inverse_mass(c);
  s.add({0, 0, 0}, 1, w, lattice_velocity(c, 2));
  if (c.coin()) s.walls.push_back({n, small_integer(c, 4)});
  return s;
}

/// The numbers of another family, with the inverse mass of each body as many times as great, or less.
inline Stepping unequal_balls(DrawStream& c) {
  Stepping s = c.coin() ? stacked_balls(c) : row_of_balls(c);
  constexpr int ratios[]{0, 40, -53, 107, -400, 900};
  for (StepBodyd& body : s.bodies) body.inverse_mass = std::ldexp(body.inverse_mass, ratios[c.below(6)]);
  return s;
}

/// Full digits, balls so near that most meet.
inline Stepping full_digit_balls(DrawStream& c) {
  Stepping s = empty_stepping(c);
  const std::uint64_t count = 1 + c.below(3);
  s.settings.gravity = ordinary_vector(c), s.settings.timestep = 1 + ordinary(c) / 2;
  while (s.bodies.size() < count) {
    const double x = ordinary(c), y = ordinary(c), z = ordinary(c), radius = std::fabs(ordinary(c));
    const double w = c.one_in(8) ? 0 : 1 + ordinary(c) / 2;
    s.add({x, y, z}, radius, w, ordinary_vector(c));
  }
  if (c.coin()) {
    const Vector3d n = not_zero(ordinary_vector(c));
    s.walls.push_back({n, ordinary(c)});
  }
  return s;
}

/// Two balls of full digits whose radii add up to the distance of their ends, but for a few units in the last place.
inline Stepping rounded_tangent_balls(DrawStream& c) {
  Stepping s = empty_stepping(c);
  const Vector3d p = ordinary_vector(c), q = ordinary_vector(c), v = ordinary_vector(c), w = ordinary_vector(c);
  s.settings.gravity = {0, 0, 0};
  const double h = s.settings.timestep, distance = std::sqrt(dot(q - p, q - p));
  const double radius = distance * up_to(c, 8) / 8, other = ulps_apart(c, distance - radius, 3);
  const Vector3d back = -h * v, other_back = -h * w;
  s.bodies.push_back({1, v, {Point3d{p.x, p.y, p.z} + back, radius}});
  s.bodies.push_back({1, w, {Point3d{q.x, q.y, q.z} + other_back, std::fabs(other)}});
  return s;
}

/// Positions, velocities, a timestep or normals at the ends of the range.
inline Stepping balls_at_the_ends(DrawStream& c) {
  Stepping s = c.coin() ? tangent_balls(c) : ball_in_a_corner(c);
  constexpr double timesteps[]{0x1p-1074, 0x1p1023, 0x1p-600, 0x1p500};
  const std::uint64_t which = c.below(6);
  for (StepBodyd& body : s.bodies) {
    if (validation::zero(body.inverse_mass)) continue;
    if (which == 0) body.velocity = at_the_end_of_range(c);
    if (which == 1) body.velocity = at_the_end_of_products(c);
    if (which == 2) body.sphere.radius = std::ldexp(body.sphere.radius, 1000);
  }
  if (which == 3) s.settings.timestep = timesteps[c.below(4)];
  if (which == 4) s.settings.gravity = at_the_end_of_range(c);
  for (Plane3d& wall : s.walls)
    if (which == 5) wall.normal = stretched_normal(c);
  s.settings.restitution = restitution_at_an_end(c);
  return s;
}

/// Position and velocity so near to the middle between two doubles that only their last digits tell.
inline Stepping step_beside_a_tie(DrawStream& c) {
  Stepping s = empty_stepping(c);
  if (c.coin()) {
    const NearTie tie = near_tie(c);
    s.settings.gravity = {0, 0, 0}, s.settings.timestep = tie.t;
    s.bodies.push_back({1, {tie.v, 0, 0}, {{tie.rest, 0, 0}, 1}});
    return s;
  }
  // As contact_beside_a_tie: balls of great radii, so that they meet.
  const Impact i = impact_beside_a_tie(c);
  const double touch = 0x1p60;
  s.settings.gravity = {0, 0, 0}, s.settings.timestep = 1, s.settings.restitution = 1;
  s.bodies.push_back({i.masses.second, i.velocities.first, {{touch, 0, 0}, touch}});
  s.bodies.push_back({i.masses.first, i.velocities.second, {{-touch, 0, 0}, 3 * touch}});
  return s;
}

/// Many balls in a row, each of which touches the next; or pairs, each for itself. They come to rest at the end.
inline Stepping many_balls(DrawStream& c) {
  Stepping s = empty_stepping(c);
  s.settings.gravity = {0, 0, 0};
  const bool pairs = c.coin();
  const std::uint64_t moving = 1 + c.below(2);
  double place = 0;
  const auto ball = [&](DrawStream& d) {
    const bool first = place < static_cast<double>(moving);
    const double x = pairs ? 2 * place + std::floor(place / 2) : 2 * place, speed = first ? 8 : -up_to(d, 1);
    place += 1;
    Stepping one{{}, {}, s.settings};
    one.add({x, 0, 0}, 1, 1, {speed, 0, 0});
    return one.bodies[0];
  };
  s.bodies = long_list(c, ball, 40);
  s.settings.restitution = c.coin() ? 0 : 1;
  return s;
}

/// A ball among many walls, of which the last are those that it meets.
inline Stepping many_walls(DrawStream& c) {
  Stepping s = empty_stepping(c);
  s.settings.gravity = {0, 0, 0};
  s.add({0, 1, 0}, 1, 1, lattice_velocity(c, 3));
  const auto far = [](DrawStream& d) {
    const double distance = 4 + up_to(d, 7);
    return Plane3d{{0, 1, 0}, distance};
  };
  s.walls = long_list(c, far, 300);
  const std::size_t late = late_index(s.walls.size(), c);
  s.walls[late] = {{0, 1, 0}, 0};
  if (c.coin()) s.walls.back() = {{1, 0, 0}, 1};
  return s;
}

/// A timestep that is not positive, a restitution beyond its ends, a wall without a normal, a body of a negative mass
/// or radius, or a velocity of one that never moves.
inline void break_one_rule(std::vector<StepBodyd>& bodies, std::vector<Plane3d>& walls, double& timestep,
                           double& restitution, DrawStream& c) {
  const Vector3d n = zero_vector(c);
  StepBodyd& body = bodies[c.below(bodies.size())];
  switch (c.below(7)) {
    case 0: timestep = zero(c); break;
    case 1: timestep = c.coin() ? -0x1p-1074 : -1; break;
    case 2: restitution = c.coin() ? -0x1p-1074 : 0x1.0000000000001p0; break;
    case 3: walls.push_back({n, small_integer(c)}); break;
    case 4: body.inverse_mass = c.coin() ? -0x1p-1074 : -1; break;
    case 5: body.sphere.radius = c.coin() ? -0x1p-1074 : -1; break;
    default: body.inverse_mass = 0, body.velocity = {0, 0, c.coin() ? 0x1p-1074 : 1};
  }
}

/// Something that is refused, somewhere.
inline Stepping refused_step(DrawStream& c) {
  Stepping s = lattice_balls(c);
  break_one_rule(s.bodies, s.walls, s.settings.timestep, s.settings.restitution, c);
  return s;
}

}  // namespace touchstone::catalogue
