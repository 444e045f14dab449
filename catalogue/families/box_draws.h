// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "catalogue/families/numbers.h"
#include "geometry/volumes.h"

/// Boxes, drawn from a draw stream as exact integers.
namespace touchstone::catalogue {

inline Point3d lattice_point_of_box(DrawStream& draws, int bits = 24) {
  return {integer(draws, bits), integer(draws, bits), integer(draws, bits)};
}

/// With an interior; 1 wide at the least.
inline Aabb3d lattice_box(DrawStream& draws, int bits = 24) {
  const Point3d p = lattice_point_of_box(draws, bits);
  return {p, p + Vector3d{one_to(draws, 8), one_to(draws, 8), one_to(draws, 8)}};
}

/// Another box that has a part of a's interior.
inline Aabb3d overlapping(const Aabb3d& a, DrawStream& draws) {
  const auto least = [&draws](double low, double high) {
    return low + static_cast<double>(draws.below(static_cast<std::uint64_t>(high - low)));
  };
  const Point3d p{least(a.min.x, a.max.x), least(a.min.y, a.max.y), least(a.min.z, a.max.z)};
  return {p, p + Vector3d{one_to(draws, 8), one_to(draws, 8), one_to(draws, 8)}};
}

/// A part of a, perhaps all, perhaps flat.
inline Aabb3d within(const Aabb3d& a, DrawStream& draws) {
  const auto part = [&draws](double& low, double& high) {
    low += static_cast<double>(draws.below(static_cast<std::uint64_t>(high - low) + 1));
    high -= static_cast<double>(draws.below(static_cast<std::uint64_t>(high - low) + 1));
  };
  Aabb3d b = a;
  part(b.min.x, b.max.x), part(b.min.y, b.max.y), part(b.min.z, b.max.z);
  return b;
}

/// Makes a rectangle, a segment or a point of it.
inline void flatten(Aabb3d& box, DrawStream& draws) {
  const auto axes = draws.below(7);
  if (axes != 1 && axes != 2 && axes != 5) box.max.x = box.min.x;
  if (axes == 1 || axes > 3) box.max.y = box.min.y;
  if (axes == 2 || axes == 3 || axes > 4) box.max.z = box.min.z;
}

inline Aabb3d shifted(const Aabb3d& b, double x, double y, double z) {
  return {{b.min.x + x, b.min.y + y, b.min.z + z}, {b.max.x + x, b.max.y + y, b.max.z + z}};
}
inline Aabb2d without_z(const Aabb3d& b) { return {{b.min.x, b.min.y}, {b.max.x, b.max.y}}; }

/// A vector of multiples of 2^-30 below 1: what is moved by it has digits to lose.
inline Vector3d fractions(DrawStream& draws) {
  const auto fraction = [&draws] { return std::ldexp(static_cast<double>(draws.below(1 << 30)), -30); };
  return {fraction(), fraction(), fraction()};
}

/// The sides that p does not see are moved away, by 2^20 to 2^56: half the sum of both ends, and half their difference,
/// no longer hold the digits of the near end.
inline Aabb3d widened(Aabb3d box, const Point3d& p, DrawStream& draws) {
  const auto widen = [&draws](double& min, double& max, double at) {
    const double far = scaled_up(draws, 8, 34) * 0x1p20;
    const bool up = at < min || (at <= max && draws.coin());
    if (up) max += far;
    else min -= far;
  };
  widen(box.min.x, box.max.x, p.x), widen(box.min.y, box.max.y, p.y), widen(box.min.z, box.max.z, p.z);
  return box;
}

/// min and max exchanged where they stand the wrong way round.
inline void put_in_order(double& min, double& max) {
  if (min > max) std::swap(min, max);
}
inline void put_in_order(Aabb2d& b) { put_in_order(b.min.x, b.max.x), put_in_order(b.min.y, b.max.y); }
inline void put_in_order(Aabb3d& b) {
  put_in_order(b.min.x, b.max.x), put_in_order(b.min.y, b.max.y), put_in_order(b.min.z, b.max.z);
}

/// The box between two points that number(draws) draws.
template <class Draw>
Aabb3d box_of(DrawStream& draws, const Draw& number) {
  Aabb3d box{{number(draws), number(draws), number(draws)}, {number(draws), number(draws), number(draws)}};
  put_in_order(box);
  return box;
}

}  // namespace touchstone::catalogue
