// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <touchstone/geometry/space.h>
#include <touchstone/geometry/volumes.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

/// Other parameters of the same shape, where they are exact: engines keep a box by its center and half its size, a
/// motion by its end. What they cannot hold exactly they are not asked. Rounding to nearest.
namespace touchstone::exactly {

/// a + b, if no rounding happens (Knuth: two_sum).
template <class Real>
std::optional<Real> sum(Real a, Real b) {
  const Real s = a + b, of_b = s - a, lost = (a - (s - of_b)) + (b - of_b);
  if (!std::isfinite(s) || !std::isfinite(of_b) || lost != 0) return std::nullopt;
  return s;
}

template <class Real>
std::optional<Real> half(Real a) {
  const Real h = a / 2;
  if (h + h != a) return std::nullopt;
  return h;
}

template <class Real>
std::optional<Real> square(Real a) {
  const Real s = a * a;
  const bool whole = a == 0 || (s > 1e-30F && std::fma(a, a, -s) == 0);
  if (!std::isfinite(s) || !whole) return std::nullopt;
  return s;
}

template <class Real>
std::optional<Vector3<Real>> sum(const Vector3<Real>& a, const Vector3<Real>& b) {
  const auto x = sum(a.x, b.x), y = sum(a.y, b.y), z = sum(a.z, b.z);
  if (!x || !y || !z) return std::nullopt;
  return Vector3<Real>{*x, *y, *z};
}
template <class Real>
std::optional<Vector3<Real>> difference(const Vector3<Real>& a, const Vector3<Real>& b) {
  return sum(a, Vector3<Real>{-b.x, -b.y, -b.z});
}
template <class Real>
std::optional<Point3<Real>> moved(const Point3<Real>& p, const Vector3<Real>& v) {
  const auto end = sum(Vector3<Real>{p.x, p.y, p.z}, v);
  if (!end) return std::nullopt;
  return Point3<Real>{end->x, end->y, end->z};
}

/// The points center + (+-half.x, +-half.y, +-half.z): all of a box's numbers, its whole size among them, are exact.
template <class Real>
struct Box {
  Point3<Real> center;
  Vector3<Real> half;
};

template <class Real>
std::optional<std::pair<Real, Real>> middle_and_half(Real min, Real max) {
  const auto twice = sum(min, max), size = sum(max, -min);
  if (!twice || !size) return std::nullopt;
  const auto middle = half(*twice), reach = half(*size);
  if (!middle || !reach) return std::nullopt;
  return std::pair{*middle, *reach};
}

template <class Real>
std::optional<Box<Real>> box(const Aabb3<Real>& aabb) {
  const auto x = middle_and_half(aabb.min.x, aabb.max.x), y = middle_and_half(aabb.min.y, aabb.max.y),
             z = middle_and_half(aabb.min.z, aabb.max.z);
  if (!x || !y || !z) return std::nullopt;
  return Box<Real>{{x->first, y->first, z->first}, {x->second, y->second, z->second}};
}

/// A box whose half axes lie along the axes of coordinates, in any order: of others an engine needs a rotation, which
/// it cannot hold exactly.
template <class Real>
std::optional<Box<Real>> upright(const Obb3<Real>& obb) {
  const auto& [u, v, w] = obb.half_axes;
  Vector3<Real> half{0, 0, 0};
  for (const Vector3<Real>& axis : {u, v, w}) {
    const int along = (axis.x != 0) + (axis.y != 0) + (axis.z != 0);
    const bool taken = (axis.x != 0 && half.x != 0) || (axis.y != 0 && half.y != 0) || (axis.z != 0 && half.z != 0);
    if (along != 1 || taken) return std::nullopt;
    half = {half.x + std::abs(axis.x), half.y + std::abs(axis.y), half.z + std::abs(axis.z)};
  }
  const Vector3<Real> size{2 * half.x, 2 * half.y, 2 * half.z};
  if (!std::isfinite(size.x) || !std::isfinite(size.y) || !std::isfinite(size.z)) return std::nullopt;
  return Box<Real>{obb.center, half};
}

/// A plane whose normal lies along an axis of coordinates, by the normal of length 1 and the offset that goes with it:
/// other normals an engine rounds, and so it does an offset that is no multiple of the normal's length.
template <class Real>
std::optional<Plane<Real>> across_axis(const Plane<Real>& plane) {
  const Vector3<Real>& n = plane.normal;
  if ((n.x != 0) + (n.y != 0) + (n.z != 0) != 1) return std::nullopt;
  const Real length = std::abs(n.x + n.y + n.z), offset = plane.offset / length;
  if (!std::isfinite(offset) || std::fma(offset, length, -plane.offset) != 0) return std::nullopt;
  return Plane<Real>{{n.x / length, n.y / length, n.z / length}, offset};
}

/// Corner i of a parallelepiped is on the far side of half axis k if bit k of i is set.
template <class Real>
std::optional<std::vector<Point3<Real>>> corners(const Obb3<Real>& obb) {
  std::vector<Point3<Real>> all{obb.center};
  const auto& [u, v, w] = obb.half_axes;
  for (const Vector3<Real>& axis : {u, v, w}) {
    const std::size_t count = all.size();
    for (const Real side : {Real(-1), Real(1)}) {
      for (std::size_t i = 0; i < count; ++i) {
        const auto corner = moved(all[i], side * axis);
        if (!corner) return std::nullopt;
        all.push_back(*corner);
      }
    }
    all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return all;
}

}  // namespace touchstone::exactly
