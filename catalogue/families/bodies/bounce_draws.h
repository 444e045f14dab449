// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

#include "catalogue/families/space_draws.h"
#include "catalogue/families/ties.h"

/// Velocities and normals before a bounce, drawn from a draw stream.
namespace touchstone::catalogue {

struct Bounce {
  Vector3d velocity, normal;
};

inline Vector3d lattice_velocity(DrawStream& c, int bits = 26) {
  return {integer(c, bits), integer(c, bits), integer(c, bits)};
}
inline Vector3d ordinary_vector(DrawStream& c) { return {ordinary(c), ordinary(c), ordinary(c)}; }
inline Vector3d zero_vector(DrawStream& c) { return {zero(c), zero(c), zero(c)}; }

/// The normal along an axis, of any sign: zeros next to one number.
inline Vector3d axis_normal(DrawStream& c) {
  Vector3d n = zero_vector(c);
  const double length = one_to(c, 8), signed_length = either_sign(c) * length;
  switch (c.below(3)) {
    case 0: n.y = signed_length; break;
    case 1: n.x = signed_length; break;
    default: n.z = signed_length;
  }
  return n;
}

inline Bounce lattice_bounce(DrawStream& c) { return {lattice_velocity(c), lattice_normal(c)}; }

/// Along the plane: the velocity stays as it is, and both products that cancel are long.
inline Bounce along_the_plane(DrawStream& c) {
  const Vector3d n = lattice_normal(c);
  return {lattice_across(c, n), n};
}

/// Nearly along the plane: a long part along it, and a short one along the normal.
inline Bounce grazing(DrawStream& c) {
  const Vector3d n = lattice_normal(c, 10), across = lattice_across(c, n);
  const double part = small_integer(c), size = power_of_two(c, 0, 35);
  return {size * across + part * n, n};
}

inline Bounce straight(DrawStream& c) {
  const Vector3d n = lattice_normal(c);
  return {integer(c, 20) * n, n};
}

inline Bounce across_an_axis(DrawStream& c) {
  const Vector3d n = axis_normal(c);
  return {c.one_in(4) ? zero_vector(c) : ordinary_vector(c), n};
}

/// A normal of length 1e-200, 1e200 and beyond, or of subnormal numbers: its squares under- and overflow.
inline Vector3d stretched_normal(DrawStream& c) {
  const Vector3d n = lattice_normal(c, 20);
  constexpr int lengths[]{-664, 664, -540, 540, -1074, 1000};
  const int length = lengths[c.below(6)], more = integer_in(c, 0, 7);
  return std::ldexp(1, length + more) * n;
}
inline Bounce stretched_bounce(DrawStream& c) { return {lattice_velocity(c), stretched_normal(c)}; }

/// Full digits at an exponent where a product of two underflows in part, or squares overflow.
inline double at_the_end(DrawStream& c, int exponent) { return std::ldexp(ordinary(c), exponent); }
inline Vector3d at_the_end_of_products(DrawStream& c) {
  const int size = integer_in(c, 480, 549), exponent = c.one_in(4) ? size : -size;
  return {at_the_end(c, exponent), at_the_end(c, exponent), at_the_end(c, exponent)};
}
inline Bounce products_at_the_end(DrawStream& c) {
  const Vector3d v = c.coin() ? ordinary_vector(c) : at_the_end_of_products(c);
  return {v, at_the_end_of_products(c)};
}

/// At a velocity at the end of the range: a component may go beyond it.
inline Vector3d at_the_end_of_range(DrawStream& c) {
  const auto end = [&c] {
    const double size = std::numeric_limits<double>::max() / one_to(c, 3);
    return either_sign(c) * size;
  };
  return {end(), end(), end()};
}
inline Bounce at_end_of_range(DrawStream& c) { return {at_the_end_of_range(c), lattice_normal(c, 3)}; }

/// With n = (1, b, 0), x - 2 (x + b y) / (1 + b^2) is an odd number of 54 digits, and 1 / (1 + b^2) less: near a tie
/// by 2^-103 of it.
inline Bounce bounce_beside_a_tie(DrawStream& c) {
  const std::uint64_t half = std::uint64_t{1} << 52, b = 2 * (1 + c.below(std::uint64_t{1} << 24));
  const std::uint64_t x = 2 * (half + (std::uint64_t{1} << 30) + c.below(half / 2)), j = (x - 1) % b;
  // x + b y = ((1 + b^2) (2 j + 1) + 1) / 2
  const double y = static_cast<double>(b / 2 * (2 * j + 1)) - static_cast<double>((x - 1 - j) / b);
  return {{static_cast<double>(x), y, 0}, {1, static_cast<double>(b), 0}};
}

/// No normal.
inline Bounce without_a_normal(DrawStream& c) { return {lattice_velocity(c), zero_vector(c)}; }

}  // namespace touchstone::catalogue
