// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "catalogue/families/space_draws.h"
#include "geometry/volumes.h"

/// Oriented boxes, drawn from a draw stream; of even integers, so that half of a half axis is an integer.
namespace touchstone::catalogue {

using HalfAxes3d = HalfAxes<double>;

inline double volume_of(const HalfAxes3d& h) { return dot(cross(h.u, h.v), h.w); }

inline std::array<Vector3d*, 3> each_of(HalfAxes3d& h) { return {&h.u, &h.v, &h.w}; }

/// The coordinate axes times even integers, in any order.
inline HalfAxes3d straight_half_axes(DrawStream& c) {
  const auto length = [&c] { return 2 * one_to(c, 4); };
  const double x = length(), y = length(), z = length();
  const Vector3d a{x, 0, 0}, b{0, y, 0}, d{0, 0, z};
  switch (c.below(3)) {
    case 0: return {a, b, d};
    case 1: return {b, d, a};
    default: return {b, a, d};
  }
}

/// At right angles to each other: a turn by an integer quaternion.
inline HalfAxes3d turned_half_axes(DrawStream& c) {
  const double a = one_to(c, 3), p = small_integer(c, 3), q = small_integer(c, 3), r = small_integer(c, 3);
  HalfAxes3d h{{a * a + p * p - q * q - r * r, 2 * (p * q + a * r), 2 * (p * r - a * q)},
               {2 * (p * q - a * r), a * a - p * p + q * q - r * r, 2 * (q * r + a * p)},
               {2 * (p * r + a * q), 2 * (q * r - a * p), a * a - p * p - q * q + r * r}};
  for (Vector3d* axis : each_of(h)) *axis = 2 * one_to(c, 3) * *axis;
  return h;
}

/// Independent integers of at most so many bits.
inline HalfAxes3d skew_half_axes(DrawStream& c, int bits = 3) {
  HalfAxes3d h{};
  for (Vector3d* axis : each_of(h)) *axis = 2.0 * lattice_normal(c, bits);
  if (volume_of(h) == 0) h = {{2, 0, 0}, {h.u.x, 4, 0}, {h.v.y, h.v.z, 2}};
  return h;
}

/// Nearly dependent: the second differs from the first by little, the third from their plane.
inline HalfAxes3d slanted_half_axes(DrawStream& c) {
  const Vector3d u = 2.0 * lattice_normal(c, 20), little = 2.0 * lattice_normal(c, 2);
  const double k = small_integer(c, 2);
  const HalfAxes3d h{u, u + little, k * u + 2.0 * lattice_normal(c, 2)};
  return volume_of(h) == 0 ? HalfAxes3d{u, {2, 2 * u.x + 2, 0}, {0, 0, 2 * u.x * u.x + 2}} : h;
}

inline HalfAxes3d lattice_half_axes(DrawStream& c) {
  switch (c.below(4)) {
    case 0: return straight_half_axes(c);
    case 1: return turned_half_axes(c);
    case 2: return skew_half_axes(c);
    default: return slanted_half_axes(c);
  }
}

inline Obb3d lattice_obb(DrawStream& c) {
  const HalfAxes3d h = lattice_half_axes(c);
  return {lattice_point_in_space(c, 20), h};
}

inline HalfAxes3d ordinary_half_axes(DrawStream& c) {
  const auto axis = [&c] { return Vector3d{ordinary(c), ordinary(c), ordinary(c)}; };
  return {axis(), axis(), axis()};
}

/// center + (r u + s v + t w) / 2
inline Point3d halves_along(const Obb3d& box, double r, double s, double t) {
  const auto& [u, v, w] = box.half_axes;
  return box.center + (r / 2 * u + (s / 2 * v + t / 2 * w));
}

/// Inside, or on the boundary.
inline Point3d in_obb(const Obb3d& box, DrawStream& c) {
  const double r = small_integer(c, 2), s = small_integer(c, 2);
  return halves_along(box, r, s, small_integer(c, 2));
}

/// On the boundary: on a face, on an edge, or a corner.
inline Point3d on_obb(const Obb3d& box, DrawStream& c) {
  const double one = either_sign(c) * 2, other = small_integer(c, 2), third = small_integer(c, 2);
  switch (c.below(3)) {
    case 0: return halves_along(box, one, other, third);
    case 1: return halves_along(box, other, one, third);
    default: return halves_along(box, other, third, one);
  }
}

/// Moves b to where it touches a from outside, as far as their half axes number i and j, a's before b's, are not
/// parallel: on the axis at right angles to both. The freedom that this axis leaves, the position along the common
/// edges or faces, is drawn in halves of these, at most so many. Exact for small integers.
inline void bring_to_touch(const Obb3d& a, Obb3d& b, std::size_t i, std::size_t j, DrawStream& c, int most_open = 2) {
  const Vector3d* edges[] = {&a.half_axes.u, &a.half_axes.v, &a.half_axes.w,
                             &b.half_axes.u, &b.half_axes.v, &b.half_axes.w};
  const Vector3d n = cross(*edges[i], *edges[j]);
  b.center = a.center;
  for (std::size_t k = 0; k < 6; ++k) {
    const double along = dot(n, *edges[k]), open = small_integer(c, most_open);
    const double halves = k == i || k == j || along == 0 ? open : along > 0 ? 2 : -2;
    b.center = b.center + halves / 2 * *edges[k];
  }
}

/// Two boxes at right angles, each rotated by itself, that only the axis across the half axes number i and j tells
/// apart, by a small gap; or that just overlap, or touch. i and j of one box: the normal of its faces on the third.
inline std::pair<Obb3d, Obb3d> apart_on_one_axis(std::size_t i, std::size_t j, DrawStream& c) {
  std::pair<Obb3d, Obb3d> boxes{{lattice_point_in_space(c, 10), turned_half_axes(c)}, {{}, turned_half_axes(c)}};
  auto& [a, b] = boxes;
  bring_to_touch(a, b, i, j, c, 1);
  const Vector3d edges[] = {a.half_axes.u, a.half_axes.v, a.half_axes.w, b.half_axes.u, b.half_axes.v, b.half_axes.w};
  const Vector3d n = cross(edges[i], edges[j]);
  const double largest = std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)});
  if (largest == 0) return boxes;  // parallel
  static constexpr double gaps[] = {1, 1, 1, 1, 1, -1, -1, 0};
  const double gap = gaps[c.below(8)];
  const int size = -std::ilogb(largest) - 2 - integer_in(c, 0, 15);
  b.center = b.center + std::ldexp(gap, size) * n;
  return boxes;
}

/// Two beams on edge, one on the other, their ridges rotated against each other by an angle of twice `half`: along the
/// normals of faces, which stand at 45 degrees, there is no gap. Without a sine, of which every library has its own.
inline std::pair<Obb3d, Obb3d> beams_on_edge(DrawStream& c) {
  static constexpr double halves[] = {0.5e-4, 0.5e-3, 0.5e-5, 0.5e-6};
  const double half = halves[c.below(4)], length = 2 / half * scaled_up(c, 4, 8), more = 1 + half * half;
  const double x = (1 - half * half) / more, y = 2 * half / more, r = one_to(c, 4), s = one_to(c, 4);
  const double displacement = small_integer(c, 2), gap = std::ldexp(displacement, -integer_in(c, 0, 19));
  return {{{0, 0, 0}, {{length, 0, 0}, {0, r, r}, {0, -r, r}}},
          {{small_integer(c, 4), 0, 2 * r + 2 * s + gap},
           {{length * x, length * y, 0}, {-s * y, s * x, s}, {s * y, -s * x, s}}}};
}

/// A box with the half axes of another, in another order and perhaps half or twice as long, its center on the grid of
/// halves of these.
inline Obb3d alike(const Obb3d& a, DrawStream& c) {
  const auto [u, v, w] = a.half_axes;
  Obb3d b{{}, c.coin() ? HalfAxes3d{v, w, u} : HalfAxes3d{u, v, w}};
  for (Vector3d* axis : each_of(b.half_axes)) {
    static constexpr double factors[] = {1, 0.5, 2, -1};
    *axis = factors[c.below(4)] * *axis;
  }
  const double r = small_integer(c, 4), s = small_integer(c, 4);
  b.center = halves_along(a, r, s, small_integer(c, 4));
  return b;
}

/// A box around the origin, each half axis of its own size, from one end of the range to the other.
inline Obb3d long_and_thin_obb(DrawStream& c) {
  Obb3d box{{0, 0, 0}, lattice_half_axes(c)};
  for (Vector3d* axis : each_of(box.half_axes)) {
    const int k = integer_in(c, -1080, 919);
    *axis = scaled(*axis, k);
  }
  return box;
}

}  // namespace touchstone::catalogue
