// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include "geometry/space.h"
#include "geometry/thin_shapes.h"
#include "robust/kernel/solids/parallelepiped.h"

/// Hulls of up to three points, and the intersection of two of them in one plane: written once for both exact stages,
/// like kernel/plane.h. Dimensions are 0, 1, 2; -1 for empty.
namespace touchstone::robust::kernel {

/// v x w, and the signs of its products with vectors.
template <class Integer>
struct Normal : Vector3<Second<Integer>> {
  Normal(const Vector3<Integer>& v, const Vector3<Integer>& w) : Vector3<Second<Integer>>(axis_across(v, w)) {}
  bool zero() const { return sign_of(this->x) == 0 && sign_of(this->y) == 0 && sign_of(this->z) == 0; }
  int along(const Vector3<Integer>& d) const { return sign_of(product_with_axis<Integer>(*this, d)); }
};

/// The distinct corners of the hull; three are not collinear, and counter-clockwise in the plane. The entries after the
/// last repeat it.
template <class Point>
struct SmallHull {
  std::array<Point, 3> at;
  std::size_t count;
  const Point& operator[](std::size_t i) const { return at[i]; }
  const Point& next(std::size_t i) const { return at[i + 1 == count ? 0 : i + 1]; }
};
template <class Integer>
using HullInSpace = SmallHull<Point3<Integer>>;
template <class Integer>
using HullInPlane = SmallHull<Point2<Integer>>;

/// The number of an axis x, y, z that is not in the plane spanned by the displacements from one point to others; or, if
/// all are collinear, one along which that line does not lead.
template <class Integer>
std::size_t axis_to_look_along(std::span<const Vector3<Integer>> displacements) {
  const Vector3<Integer>* along = &displacements[0];
  for (const Vector3<Integer>& displacement : displacements) {
    if (sign_of(along->x) == 0 && sign_of(along->y) == 0 && sign_of(along->z) == 0) along = &displacement;
    const Normal<Integer> normal(*along, displacement);
    if (!normal.zero()) return sign_of(normal.x) != 0 ? 0 : sign_of(normal.y) != 0 ? 1 : 2;
  }
  return sign_of(along->x) != 0 ? 2 : sign_of(along->y) != 0 ? 0 : 1;
}

template <class Integer>
Point2<Integer> projected_along(std::size_t axis, const Point3<Integer>& p) {
  if (axis == 0) return {p.y, p.z};
  if (axis == 1) return {p.z, p.x};
  return {p.x, p.y};
}
template <class Integer>
HullInPlane<Integer> projected_along(std::size_t axis, const HullInSpace<Integer>& hull) {
  HullInPlane<Integer> projected{{}, hull.count};
  for (std::size_t k = 0; k < 3; ++k) projected.at[k] = projected_along(axis, hull[k]);
  if (projected.count == 3 && turn(projected[0], projected[1], projected[2]) < 0)
    std::swap(projected.at[1], projected.at[2]);
  return projected;
}

/// Part of a line, from its least point to its greatest in lexicographic order.
template <class Integer>
struct PartOfLine {
  Point2<Integer> least, greatest;
  bool empty = true;

  void add(const Point2<Integer>& p) {
    if (empty || before(p, least)) least = p;
    if (empty || before(greatest, p)) greatest = p;
    empty = false;
  }

  int common_dimension(const PartOfLine& other) const {
    if (empty || other.empty) return -1;
    const Point2<Integer>& from = before(least, other.least) ? other.least : least;
    const Point2<Integer>& to = before(greatest, other.greatest) ? greatest : other.greatest;
    return before(from, to) ? 1 : from == to ? 0 : -1;
  }

  /// The intersection with a ray on the line.
  int common_dimension(const Ray2<Integer>& ray) const {
    if (empty) return -1;
    const bool up = before(ray.origin, ray.origin + ray.direction);
    const Point2<Integer>& farthest = up ? greatest : least;
    if (farthest == ray.origin) return 0;
    if (before(ray.origin, farthest) != up) return -1;
    return least == greatest ? 0 : 1;
  }
};

/// The intersection of two coplanar hulls. If the line of an edge has its own hull on the left and nothing of the
/// other, they intersect in the common part of both on that line. If there is no such edge, their insides meet: each
/// edge of the hull of all differences of a point of one and a point of the other is parallel to an edge of one of the
/// two.
template <class Integer>
int common_dimension(const HullInPlane<Integer>& a, const HullInPlane<Integer>& b) {
  for (const auto& [hull, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (std::size_t i = 0; hull->count > 1 && i < hull->count; ++i) {
      const Point2<Integer>&from = (*hull)[i], &to = hull->next(i);
      PartOfLine<Integer> edge, touching;
      bool on_left = false;
      for (std::size_t k = 0; k < other->count && !on_left; ++k) {
        const int side = turn(from, to, (*other)[k]);
        on_left = side > 0;
        if (side == 0) touching.add((*other)[k]);
      }
      edge.add(from), edge.add(to);
      if (!on_left) return edge.common_dimension(touching);
    }
  }
  if (a.count == 1 && b.count == 1) return a[0] == b[0] ? 0 : -1;
  return static_cast<int>(a.count + b.count) - 4;
}

/// The same for a ray.
template <class Integer>
int common_dimension(const Ray2<Integer>& ray, const HullInPlane<Integer>& hull) {
  const auto& [origin, displacement] = ray;
  for (std::size_t i = 0; hull.count > 1 && i < hull.count; ++i) {
    const Point2<Integer>&from = hull[i], &to = hull.next(i);
    const int at_origin = turn(from, to, origin), rise = turn(to - from, displacement);
    if (at_origin > 0 || rise > 0) continue;
    if (at_origin < 0) return -1;
    PartOfLine<Integer> edge, touching;
    edge.add(from), edge.add(to), touching.add(origin);
    return rise == 0 ? edge.common_dimension(ray) : edge.common_dimension(touching);
  }
  PartOfLine<Integer> on_line;
  bool left = false, right = false;
  for (std::size_t k = 0; k < hull.count; ++k) {
    const int side = turn(displacement, hull[k] - origin);
    left = left || side > 0, right = right || side < 0;
    if (side == 0) on_line.add(hull[k]);
  }
  return left && right ? static_cast<int>(hull.count) - 2 : on_line.common_dimension(ray);
}

}  // namespace touchstone::robust::kernel
