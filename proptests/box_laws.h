// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "proptests/closest_laws.h"
#include "robust/volumes/point_in_obb.h"

/// Laws of oriented boxes.
namespace touchstone::proptests {

/// Boxes of the examples worked by hand.
namespace worked_boxes {
inline constexpr Obb3d cube{{0, 0, 0}, {{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}};
inline constexpr Obb3d turned{{0, 0, 0}, {{3, 4, 0}, {-4, 3, 0}, {0, 0, 1}}};  // by the triple 3, 4, 5
inline constexpr Obb3d sheared{{0, 0, 0}, {{2, 0, 0}, {6, 2, 0}, {0, 0, 1}}};  // y from -2 to 2, |x - 3 y| <= 2
inline constexpr Obb3d least{{0, 0, 0}, {{tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}}};
}  // namespace worked_boxes

/// The eight corners; exact on the lattice.
inline std::vector<Point3d> corners(const Obb3d& box) {
  const auto& [u, v, w] = box.half_axes;
  std::vector<Point3d> all;
  for (const double r : {-1.0, 1.0})
    for (const double s : {-1.0, 1.0})
      for (const double t : {-1.0, 1.0}) all.push_back(box.center + (r * u + (s * v + t * w)));
  return all;
}

/// A box along the axes, its half axes of the lengths of the diagonal of a box's, as both kinds; exact on the lattice.
/// None if it is flat.
struct Straight {
  Obb3d obb;
  Aabb3d aabb;
};
inline std::optional<Straight> straightened(const Obb3d& box) {
  const auto& [u, v, w] = box.half_axes;
  const Point3d& c = box.center;
  if (u.x == 0 || v.y == 0 || w.z == 0) return std::nullopt;
  const double x = std::fabs(u.x), y = std::fabs(v.y), z = std::fabs(w.z);
  return Straight{{c, {{u.x, 0, 0}, {0, v.y, 0}, {0, 0, w.z}}},
                  {{c.x - x, c.y - y, c.z - z}, {c.x + x, c.y + y, c.z + z}}};
}

inline Vector3<Rational> exact_vector(const Vector3d& v) { return {exact(v.x), exact(v.y), exact(v.z)}; }
inline Obb3<Rational> exact_obb(const Obb3d& box) {
  const auto& [u, v, w] = box.half_axes;
  return {exact_point(box.center), {exact_vector(u), exact_vector(v), exact_vector(w)}};
}
inline bool has_right_angles(const Obb3d& box) {
  const auto [u, v, w] = exact_obb(box).half_axes;
  return sgn(dot(u, v)) == 0 && sgn(dot(v, w)) == 0 && sgn(dot(w, u)) == 0;
}
inline bool holds_point(const Obb3d& box, const Point3d& p) {
  return robust::point_in_obb(box, p) != Location::outside;
}
/// Half axes twice as long; none if they would leave the range.
inline std::optional<Obb3d> twice_as_large(Obb3d box) {
  for (Vector3d* axis : {&box.half_axes.u, &box.half_axes.v, &box.half_axes.w}) {
    *axis = 2.0 * *axis;
    if (!finite(axis->x, axis->y, axis->z)) return std::nullopt;
  }
  return box;
}

/// What the contract of sphere_obb promises of the point of a box that it takes: where that is in exact arithmetic, and
/// how far each coordinate is off.
struct ObbBound {
  bool defined = true;
  Point3<Rational> exactly{};
  Vector3<Rational> of_coordinate{};
  Rational sum;

  ObbBound(const Point3d& p, const Obb3d& box) {
    const Rational u = unit();
    const Vector3<Rational> d = exact_point(p) - exact_point(box.center);
    Vector3<Rational> along{}, error{};
    for (const Vector3d& axis : {box.half_axes.u, box.half_axes.v, box.half_axes.w}) {
      const Vector3<Rational> a = exact_vector(axis), size{abs(a.x), abs(a.y), abs(a.z)};
      const double length = dot(axis, axis);
      defined = defined && length >= 0x1p-960 && finite(length, dot(p - box.center, axis));
      if (!defined) return;
      const Rational products = abs(d.x) * size.x + abs(d.y) * size.y + abs(d.z) * size.z,
                     of_t = ((5 + 11 * u) * u * products + power_of_two(-1073)) / dot(a, a) + 7 * u,
                     share = std::clamp(Rational(dot(d, a) / dot(a, a)), Rational(-1), Rational(1));
      along = along + share * a, error = error + Rational(of_t * (1 + 6 * u) + 5 * u) * size;
    }
    exactly = exact_point(box.center) + along;
    const auto of = [&u](const Rational& e, const Rational& x) {
      return Rational(e + u * abs(x) + power_of_two(-1073));
    };
    of_coordinate = {of(error.x, exactly.x), of(error.y, exactly.y), of(error.z, exactly.z)};
    sum = of_coordinate.x + of_coordinate.y + of_coordinate.z;
  }
};

/// The question with the half axes of the box that is its part of that number exchanged and one reversed.
template <std::size_t part, class Asked>
Asked in_another_order(Asked asked) {
  auto& [u, v, w] = std::get<part>(asked).half_axes;
  std::get<part>(asked).half_axes = {w, {-u.x, -u.y, -u.z}, v};
  return asked;
}

}  // namespace touchstone::proptests
