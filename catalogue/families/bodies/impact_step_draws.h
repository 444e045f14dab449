// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "catalogue/families/bodies/step_draws.h"
#include "geometry/impacts.h"

/// Balls and walls before a step in which they collide when they meet, drawn from a draw stream.
namespace touchstone::catalogue {

struct Impacting {
  std::vector<StepBodyd> bodies;
  std::vector<Plane3d> walls;
  double restitution, timestep;

  /// Without a velocity if it never moves.
  void add(const Point3d& center, double radius, double inverse_mass, const Vector3d& velocity) {
    const Vector3d still{0, 0, 0};
    bodies.push_back({inverse_mass, validation::zero(inverse_mass) ? still : velocity, {center, radius}});
  }
};

inline Impacting empty_impacting(DrawStream& c) {
  constexpr double timesteps[]{1, 0.5, 0.25, 2, 0x1p-6};
  const double h = timesteps[c.below(5)];
  return {{}, {}, drawn_restitution(c), h};
}

/// A few balls of small integers, so near that most collide; perhaps walls.
inline Impacting lattice_impacts(DrawStream& c) {
  Impacting s = empty_impacting(c);
  const std::uint64_t count = 1 + c.below(4);
  while (s.bodies.size() < count) {
    const double x = small_integer(c, 8), y = small_integer(c, 8), z = small_integer(c, 1);
    const double radius = up_to(c, 3), w = lattice_inverse_mass(c);
    s.add({x, y, z}, radius, w, lattice_velocity(c, 4));
  }
  while (s.walls.size() < 2 && c.one_in(3)) {
    const Vector3d n = lattice_normal(c, 2);
    s.walls.push_back({n, small_integer(c, 6)});
  }
  return s;
}

/// Two balls head on, that meet at a rational moment: at the start, within the step, just at its end, or just after.
inline Impacting balls_head_on(DrawStream& c) {
  Impacting s = empty_impacting(c);
  const auto [n, length] = integer_normal(c);
  const double wait = up_to(c, 4) / 4, w = 1 + lattice_inverse_mass(c);
  const double part = up_to(c, 4) / 4, other = lattice_inverse_mass(c);
  const Vector3d v = n, u = c.coin() ? Vector3d{0, 0, 0} : -1.0 * n;
  const double closing = validation::zero(u.x) && validation::zero(u.y) && validation::zero(u.z) ? 1 : 2;
  const double speed = validation::zero(other) ? 1 : closing, apart = 1 + wait * speed * s.timestep;
  const double radius = ulps_apart(c, (1 - part) * length, 1);
  s.add({0, 0, 0}, part * length, w, v);
  s.add(Point3d{0, 0, 0} + apart * n, std::fabs(radius), other, u);
  return s;
}

/// Balls that pass each other, and touch just so, or nearly.
inline Impacting grazing_balls(DrawStream& c) {
  Impacting s = empty_impacting(c);
  const auto [n, length] = integer_normal(c);
  const Vector3d along = lattice_across(c, n);
  const double part = up_to(c, 4) / 4, w = lattice_inverse_mass(c), far = up_to(c, 3) / 4 * s.timestep;
  const double radius = ulps_apart(c, (1 - part) * length, 1);
  s.add(Point3d{0, 0, 0} + (-far) * along, part * length, 1 + lattice_inverse_mass(c), along);
  s.add(Point3d{0, 0, 0} + n, std::fabs(radius), w, {0, 0, 0});
  if (c.one_in(4)) s.walls.push_back({n, part * length * length});
  return s;
}

/// Balls in a row, with gaps or without, that the first ones hit; perhaps a wall at the end.
inline Impacting row_of_impacts(DrawStream& c) {
  Impacting s = empty_impacting(c);
  const auto [n, length] = integer_normal(c);
  const std::uint64_t balls = 2 + c.below(4), moving = 1 + c.below(2);
  const double speed = one_to(c, 8), gap = up_to(c, 2) / 4;
  const bool alike = c.below(4) != 3;
  double place = 0;
  for (std::uint64_t i = 0; i < balls; ++i) {
    const double w = alike ? 1 : one_to(c, 4);
    const Vector3d v = speed * n;
    s.add(Point3d{0, 0, 0} + place * n, length / 2, w, i < moving ? v : Vector3d{0, 0, 0});
    place += 1 + (i == 0 ? 0.5 : c.coin() ? gap : 0);
  }
  if (c.coin()) s.walls.push_back({-1.0 * n, (place + 1) * length * length});
  s.bodies = shuffled(std::move(s.bodies), c);
  return s;
}

/// Balls on top of each other that fall to the ground together, or lie there, and one that falls on them.
inline Impacting stacked_impacts(DrawStream& c) {
  Impacting s = empty_impacting(c);
  const std::uint64_t height = 1 + c.below(3);
  const double drop = up_to(c, 2) / 2, fall = -up_to(c, 4);
  double top = drop;
  for (std::uint64_t i = 0; i < height; ++i) {
    const double radius = one_to(c, 3), w = one_to(c, 3);
    const double aside = c.one_in(4) ? small_integer(c, 2) : 0.0;
    const bool late = i + 1 == height && c.coin();
    s.add({0, top + radius + (late ? 0.5 : 0), 0}, radius, w, {aside, late ? fall - 2 : fall, 0});
    top += 2 * radius;
  }
  const double stretch = one_to(c, 4);
  if (c.below(8) != 7) s.walls.push_back({{0, stretch, 0}, 0});
  s.bodies = shuffled(std::move(s.bodies), c);
  return s;
}

/// A ball that meets two to four walls at one moment, or nearly.
inline Impacting impact_in_a_corner(DrawStream& c) {
  Impacting s = empty_impacting(c);
  const double x = small_integer(c, 20), y = small_integer(c, 20), z = small_integer(c, 20);
  const double radius = up_to(c, 4), when = up_to(c, 4) / 4 * s.timestep;
  const Vector3d v = lattice_velocity(c, 5), meets{x, y, z};
  s.add(Point3d{x, y, z} + (-when) * v, radius, 1 + lattice_inverse_mass(c), v);
  const std::uint64_t walls = 2 + c.below(3);
  while (s.walls.size() < walls) {
    const IntegerNormal wall = integer_normal(c);
    const double side = dot(wall.n, v) > 0 ? -1 : 1;
    const Vector3d n = side * wall.n;
    const double offset = radius * wall.length - dot(n, meets);
    s.walls.push_back({n, ulps_apart(c, offset, 1)});
  }
  return s;
}

/// Balls that overlap at the start, approach, part, or are at rest; centers coincide, or nearly.
inline Impacting overlapping_impacts(DrawStream& c) {
  Impacting s = empty_impacting(c);
  const std::uint64_t count = 2 + c.below(2);
  const double x = integer(c, 10), y = integer(c, 10), radius = up_to(c, 3);
  const Vector3d v = lattice_velocity(c, 3);
  for (std::uint64_t i = 0; i < count; ++i) {
    const double aside = c.coin() ? ulps_apart(c, x, 2) : x;
    const double w = lattice_inverse_mass(c), up = small_integer(c, 1), off = small_integer(c, 2);
    s.add({aside, y + off, 0}, radius, w, {v.x, v.y + up, v.z});
  }
  if (c.one_in(4)) s.walls.push_back({{0, 2, 0}, small_integer(c, 3) - 2 * y});
  return s;
}

/// Balls that never move, which one that moves meets.
inline Impacting immovable_impacts(DrawStream& c) {
  Impacting s = empty_impacting(c);
  const std::uint64_t count = 1 + c.below(4);
  const Vector3d v = lattice_velocity(c, 5);
  const double small = up_to(c, 2), w = 1 + lattice_inverse_mass(c);
  s.add({0, 0, 0}, small, w, v);
  constexpr Point3d places[]{{3, 4, 0}, {-3, 4, 0}, {0, 0, 5}, {0, 5, 0}, {0, -3, 4}};
  for (std::uint64_t i = 0; i < count; ++i) {
    const Point3d at = places[c.below(5)];
    const double radius = one_to(c, 3);
    s.add(at, radius, zero(c), {});
  }
  return s;
}

/// Particles, which meet walls and balls, but not each other.
inline Impacting impacts_of_particles(DrawStream& c) {
  Impacting s = empty_impacting(c);
  const Vector3d n = lattice_normal(c, 3);
  const std::uint64_t count = 1 + c.below(3);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Vector3d across = lattice_across(c, n), v = lattice_velocity(c, 4);
    const Point3d on = Point3d{0, 0, 0} + (c.coin() ? across : Vector3d{0, 0, 0});
    const double beyond = small_integer(c, 2), w = lattice_inverse_mass(c);
    const double none = zero(c);
    s.add(on + beyond * n, none, w, v);
  }
  s.walls.push_back({n, zero(c)});
  if (c.coin()) s.add({0, 5, 0}, 4, 1, lattice_velocity(c, 4));
  return s;
}

/// Fast bodies and thin ones, which a test at the end of the step does not see.
inline Impacting caught_bullets(DrawStream& c) {
  Impacting s = empty_impacting(c);
  const double fast = scaled_up(c, 12, 12);
  const Vector3d n = lattice_normal(c, 2);
  const double before = one_to(c, 8), aside = small_integer(c, 3);
  s.add(Point3d{aside, 0, 0} + (-before) * n, up_to(c, 1) / 8, 1, fast * n);
  const double w = lattice_inverse_mass(c);
  s.add({0, 0, 0}, 0.5, w, lattice_velocity(c, 2));
  if (c.coin()) s.walls.push_back({-1.0 * n, small_integer(c, 4) + 8});
  return s;
}

/// A wall whose normal has an irrational length, perhaps with a ball that lies on it.
inline Impacting slanted_impacts(DrawStream& c) {
  Impacting s = empty_impacting(c);
  const Vector3d n = lattice_normal(c, 3);
  const double radius = one_to(c, 4), high = up_to(c, 5);
  const Vector3d v = lattice_velocity(c, 4), across = lattice_across(c, n);
  s.add(Point3d{0, 0, 0} + high * n, radius, 1 + lattice_inverse_mass(c), v);
  if (c.coin()) s.add(Point3d{8, 8, 8} + high * n, radius, lattice_inverse_mass(c), v);
  s.walls.push_back({n, small_integer(c, 4)});
  if (c.coin()) s.walls.push_back({across.x == 0 && across.y == 0 && across.z == 0 ? n : across, 6});
  return s;
}

/// A ball that meets several others at one moment, which are its mirror images; that is rational seldom. With a floor
/// that all lie on, which are contacts at rest; then they may be more than six.
inline Impacting broken_racks(DrawStream& c) {
  Impacting s = empty_impacting(c);
  constexpr Vector3d mirrored[]{{1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}};
  const double high = one_to(c, 2), radius = 1, speed = one_to(c, 8);
  const std::uint64_t balls = 2 + c.below(3), first = c.below(2);
  const double far = one_to(c, 4), w = one_to(c, 3), lower = c.one_in(4) ? 0x1p-30 : 0;
  s.add({-far, 0, 0}, radius, 1, {speed, 0, 0});
  for (std::uint64_t i = 0; i < balls; ++i) {
    const Vector3d& m = mirrored[(first * 2 + i) % 4];
    s.add({1, high * m.y + lower * static_cast<double>(i), high * m.z}, radius, w, {0, 0, 0});
  }
  const std::uint64_t floors = c.below(6);
  for (std::uint64_t i = 0; i < floors; ++i) {
    const double stretch = static_cast<double>(i + 1);
    s.walls.push_back({{0, 0, stretch}, stretch});
  }
  s.bodies = shuffled(std::move(s.bodies), c);
  return s;
}

/// A ball between two walls, or two heavy balls, near each other: it collides as often as the step is long.
inline Impacting to_and_fro(DrawStream& c) {
  Impacting s = empty_impacting(c);
  const double room = one_to(c, 4), times = up_to(c, 39);
  const double speed = times * room / s.timestep / 2, w = c.coin() ? 1 : 0x1p20;
  s.restitution = c.coin() ? 1 : 0.5;
  const double aside = up_to(c, 1);
  s.add({room / 4, 0, 0}, 0, w, {speed, aside, 0});
  const bool heavy = c.coin();
  if (heavy) {
    const double other = lattice_inverse_mass(c, 2), nearer = up_to(c, 1);
    s.add({-4, 0, 0}, 4, 1, {0, 0, 0});
    s.add({room + 4, 0, 0}, 4, other, {-nearer, 0, 0});
  } else {
    s.walls.push_back({{1, 0, 0}, 0});
    s.walls.push_back({{-1, 0, 0}, room});
  }
  s.bodies = shuffled(std::move(s.bodies), c);
  return s;
}

/// Pairs far from each other that meet at one moment, or so little apart that only many digits tell.
inline Impacting equal_moments(DrawStream& c) {
  Impacting s = empty_impacting(c);
  const double x = 2 + up_to(c, 2), y = up_to(c, 1), w = lattice_inverse_mass(c);
  const double speed = one_to(c, 8), far = 0x1p10, other_speed = ulps_apart(c, speed, 1);
  s.add({0, 0, 0}, 1, 1, {speed, 0, 0});
  s.add({x, y, 0}, 1, w, {0, 0, 0});
  s.add({far, 0, 0}, 1, 1, {0, other_speed, 0});
  s.add({far, x, y}, 1, w, {0, 0, 0});
  if (c.coin()) s.walls.push_back({{0, -1, 0}, far});
  s.bodies = shuffled(std::move(s.bodies), c);
  return s;
}

/// The numbers of another family, with the inverse mass of each body as many times as great, or less.
inline Impacting unequal_impacts(DrawStream& c) {
  Impacting s = c.coin() ? broken_racks(c) : row_of_impacts(c);
  constexpr int ratios[]{0, 40, -53, 107, -400, 900};
  for (StepBodyd& body : s.bodies) body.inverse_mass = std::ldexp(body.inverse_mass, ratios[c.below(6)]);
  return s;
}

/// Full digits, balls so near that most collide.
inline Impacting full_digit_impacts(DrawStream& c) {
  Impacting s = empty_impacting(c);
  const std::uint64_t count = 2 + c.below(2);
  s.timestep = 1 + ordinary(c) / 2;
  while (s.bodies.size() < count) {
    const double x = ordinary(c), y = ordinary(c), z = ordinary(c), radius = std::fabs(ordinary(c)) / 4;
    const double w = c.one_in(8) ? 0 : 1 + ordinary(c) / 2;
    const Vector3d aside = ordinary_vector(c);
    s.add({2 * x, 2 * y, 2 * z}, radius, w, -2.0 * Vector3d{x, y, z} + aside);
  }
  if (c.coin()) {
    const Vector3d n = not_zero(ordinary_vector(c));
    s.walls.push_back({n, 1 + ordinary(c)});
  }
  return s;
}

/// Positions, velocities, radii, a timestep or normals at the ends of the range.
inline Impacting impacts_at_the_ends(DrawStream& c) {
  Impacting s = c.coin() ? balls_head_on(c) : impact_in_a_corner(c);
  constexpr double timesteps[]{0x1p-1074, 0x1p1023, 0x1p-600, 0x1p500};
  const std::uint64_t which = c.below(5);
  for (StepBodyd& body : s.bodies) {
    if (validation::zero(body.inverse_mass)) continue;
    if (which == 0) body.velocity = at_the_end_of_range(c);
    if (which == 1) body.velocity = at_the_end_of_products(c);
    if (which == 2) body.sphere.radius = std::ldexp(body.sphere.radius, 1000);
  }
  if (which == 3) s.timestep = timesteps[c.below(4)];
  for (Plane3d& wall : s.walls)
    if (which == 4) wall.normal = stretched_normal(c);
  s.restitution = restitution_at_an_end(c);
  return s;
}

/// Many balls of which few collide: pairs, each for itself, or a row.
inline Impacting many_impacts(DrawStream& c) {
  Impacting s = empty_impacting(c);
  s.timestep = 1;
  const double gap = one_to(c, 2);
  double place = 0;
  const auto ball = [&](DrawStream& d) {
    const double speed = place == 0 ? 4 : d.one_in(8) ? -1 : 0;
    const StepBodyd body{1, {speed, 0, 0}, {{(2 + gap) * place, 0, 0}, 1}};
    place += 1;
    return body;
  };
  s.bodies = long_list(c, ball, 24);
  s.restitution = c.coin() ? 0 : 1;
  return s;
}

/// A ball among many walls, of which the last are those that it meets.
inline Impacting impacts_of_many_walls(DrawStream& c) {
  Impacting s = empty_impacting(c);
  const double vx = small_integer(c, 3), vz = small_integer(c, 3);
  s.add({0, 2, 0}, 1, 1, {vx, -2, vz});
  const auto far = [](DrawStream& d) {
    const double distance = 40 + up_to(d, 7);
    return Plane3d{{0, 1, 0}, distance};
  };
  s.walls = long_list(c, far, 200);
  const std::size_t late = late_index(s.walls.size(), c);
  s.walls[late] = {{0, 1, 0}, 0};
  if (c.coin()) s.walls.back() = {{1, 1, 0}, 1};
  return s;
}

/// Something that is refused, somewhere.
inline Impacting refused_impacts(DrawStream& c) {
  Impacting s = lattice_impacts(c);
  break_one_rule(s.bodies, s.walls, s.timestep, s.restitution, c);
  return s;
}

}  // namespace touchstone::catalogue
