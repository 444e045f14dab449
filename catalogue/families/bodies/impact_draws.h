// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/bodies/bounce_draws.h"
#include "geometry/bodies.h"

/// Two bodies before they meet, drawn from a draw stream.
namespace touchstone::catalogue {

struct Impact {
  Massesd masses;
  Velocitiesd velocities;
  Vector3d normal;
};

inline double lattice_mass(DrawStream& c) { return one_to(c, 16); }
inline Massesd lattice_masses(DrawStream& c) { return {lattice_mass(c), lattice_mass(c)}; }

inline Impact lattice_impact(DrawStream& c) {
  const Massesd m = lattice_masses(c);
  return {m, {lattice_velocity(c), lattice_velocity(c)}, lattice_normal(c)};
}

/// Both move along the normal; bodies of one mass exchange their velocities.
inline Impact head_on(DrawStream& c) {
  const Massesd m = lattice_masses(c);
  const Vector3d n = lattice_normal(c, 10);
  const double v = integer(c, 20), w = integer(c, 20);
  return {{m.first, c.coin() ? m.first : m.second}, {v * n, w * n}, n};
}

/// The relative velocity is across the normal, or nearly.
inline Impact grazing_impact(DrawStream& c) {
  const Massesd m = lattice_masses(c);
  const Vector3d n = lattice_normal(c, 10), v = lattice_velocity(c, 20);
  const double size = power_of_two(c, 0, 23);
  const Vector3d across = size * lattice_across(c, n);
  return {m, {v, v + across + small_integer(c) * n}, n};
}

/// Velocities that are the same, or differ by a few units in the last place.
inline Impact in_company(DrawStream& c) {
  const Massesd m = lattice_masses(c);
  const Vector3d v = ordinary_vector(c);
  const auto beside = [&c](double x) { return ulps_apart(c, x, 2); };
  const double x = beside(v.x), y = beside(v.y), z = beside(v.z);
  return {m, {v, {x, y, z}}, c.coin() ? ordinary_vector(c) : lattice_normal(c, 4)};
}

/// One is 1e12 times as heavy as the other, or 2^900 times, and may as well be a wall.
inline Massesd unequal_masses(DrawStream& c) {
  const double m = lattice_mass(c);
  constexpr int ratios[]{40, 53, 60, 107, 400, 900};
  const auto many_times = [&] {
    const int ratio = ratios[c.below(6)];
    return std::ldexp(lattice_mass(c), ratio);
  };
  const double heavy = c.one_in(4) ? 1e12 * m : many_times();
  if (c.coin()) return {heavy, m};
  return {m, heavy};
}
inline Impact fly_and_wall(DrawStream& c) {
  const Massesd m = unequal_masses(c);
  const Vector3d v = lattice_velocity(c, 20), w = c.coin() ? zero_vector(c) : ordinary_vector(c);
  return {m, {v, w}, lattice_normal(c, 6)};
}

inline Impact stretched_impact(DrawStream& c) {
  const Massesd m = lattice_masses(c);
  return {m, {lattice_velocity(c), lattice_velocity(c)}, stretched_normal(c)};
}

/// Full digits, all of them at the end of products or one of the three alone.
inline Impact impact_at_the_end(DrawStream& c) {
  const auto which = c.below(4);
  const Vector3d v = which == 2 || which == 3 ? at_the_end_of_products(c) : ordinary_vector(c), w = ordinary_vector(c),
                 n = which == 1 || which == 3 ? at_the_end_of_products(c) : ordinary_vector(c);
  const double mass = 1 + std::fabs(ordinary(c)), other = 1 + std::fabs(ordinary(c)),
               unit = which == 0 || which == 3 ? std::ldexp(1, -500 - integer_in(c, 0, 29)) : 1;
  return {{unit * mass, unit * other}, {v, w}, n};
}

inline Impact impact_at_end_of_range(DrawStream& c) {
  const Massesd m = lattice_masses(c);
  return {m, {at_the_end_of_range(c), at_the_end_of_range(c)}, lattice_normal(c, 3)};
}

/// With m1 + m2 = M and m2 = (M + 1) / 4, both of up to 53 digits: 2 q + 4 m2 / M is 2 q + 1, an odd number of 54
/// digits, and 1 / M more. The other body is near a halfway case too.
inline Impact impact_beside_a_tie(DrawStream& c) {
  const std::uint64_t quarter = (std::uint64_t{1} << 50) + c.below(std::uint64_t{1} << 50);
  const double q = 0x1p53 + 2 * one_to(c, std::uint64_t{1} << 51);
  const double m2 = static_cast<double>(quarter), m1 = static_cast<double>(3 * quarter - 1);
  return {{m1, m2}, {{q, 0, 0}, {q + 2, 0, 0}}, {1, 0, 0}};
}

/// A mass of 0 or less.
inline Impact without_a_mass(DrawStream& c) {
  Impact impact = lattice_impact(c);
  double& mass = c.coin() ? impact.masses.first : impact.masses.second;
  switch (c.below(3)) {
    case 0: mass = zero(c); break;
    case 1: mass = -0x1p-1074; break;
    default: mass = -mass;
  }
  return impact;
}
inline Impact impact_without_a_normal(DrawStream& c) {
  Impact impact = lattice_impact(c);
  impact.normal = zero_vector(c);
  return impact;
}

/// A mass of random bits.
inline void make_positive(double& mass) {
  mass = std::fabs(mass);
  if (mass == 0) mass = 1;
}

/// A coefficient of restitution on a bound, or the first number beyond.
inline double restitution_at_a_bound(DrawStream& c) {
  const double bound = c.coin() ? 1 : 0;
  return ulps_apart(c, bound, 1);
}

}  // namespace touchstone::catalogue
