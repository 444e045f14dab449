// SPDX-License-Identifier: Apache-2.0
#include "catalogue/draw/convex_cells.h"

#include <algorithm>
#include <cmath>

#include "catalogue/draw/side_view.h"

namespace touchstone::catalogue {
namespace {

/// A plane by a unit normal and its distance from the origin, in units in which the box is within [-1, 1].
struct UnitPlane {
  Vector3d normal;
  double offset;
  double height(const Point3d& p) const { return normal.x * p.x + normal.y * p.y + normal.z * p.z + offset; }
};

UnitPlane to_unit(const Plane3d& plane, int exponent) {
  const double size = largest(plane.normal);
  const Vector3d v{plane.normal.x / size, plane.normal.y / size, plane.normal.z / size};
  return {unit_of(v), std::ldexp(plane.offset / size, -exponent) / std::sqrt(dot(v, v))};
}

/// The part of a convex polygon in a half-space.
std::vector<Point3d> cut(const std::vector<Point3d>& ring, const UnitPlane& by) {
  std::vector<Point3d> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point3d &p = ring[i], &q = ring[(i + 1) % ring.size()];
    const double at_p = by.height(p), at_q = by.height(q);
    if (at_p >= 0) kept.push_back(p);
    if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) kept.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return kept;
}

/// A square of a plane about its point nearest to the origin that contains the plane's part in [-1, 1] cubed: no point
/// there is farther than sqrt(3) from that point.
std::vector<Point3d> square_of(const UnitPlane& plane) {
  const Vector3d& n = plane.normal;
  const double sizes[] = {std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)};
  const auto least = std::min_element(sizes, sizes + 3) - sizes;
  const Vector3d axis{least == 0 ? 1.0 : 0.0, least == 1 ? 1.0 : 0.0, least == 2 ? 1.0 : 0.0};
  const Vector3d u = 2.0 * unit_of(cross(n, axis)), v = 2.0 * unit_of(cross(n, u));
  const Point3d foot{-plane.offset * n.x, -plane.offset * n.y, -plane.offset * n.z};
  return {foot + (u + v), foot + (v - u), foot + -1.0 * (u + v), foot + (u - v)};
}

/// The exponent of a power of two that is at least every coordinate of the box of the first six half-spaces.
int exponent_of(const std::vector<HalfSpace>& half_spaces) {
  double most = 0;
  for (std::size_t i = 0; i < 6; ++i) most = std::max(most, std::fabs(half_spaces[i].offset));
  int exponent = 0;
  std::frexp(most, &exponent);
  return exponent;
}

}  // namespace

std::vector<HalfSpace> half_spaces_of(const Aabb3d& box) {
  return {{{1, 0, 0}, -box.min.x}, {{0, 1, 0}, -box.min.y}, {{0, 0, 1}, -box.min.z},
          {{-1, 0, 0}, box.max.x}, {{0, -1, 0}, box.max.y}, {{0, 0, -1}, box.max.z}};
}

std::vector<Point3d> part_of_plane(const Plane3d& plane, const std::vector<HalfSpace>& half_spaces) {
  const int exponent = exponent_of(half_spaces);
  std::vector<Point3d> ring = square_of(to_unit(plane, exponent));
  for (const HalfSpace& half_space : half_spaces) {
    if (&half_space != &plane) ring = cut(ring, to_unit(half_space, exponent));
  }
  for (Point3d& p : ring) {
    for (double* x : {&p.x, &p.y, &p.z}) {
      *x = std::ldexp(*x, exponent);
      if (!std::isfinite(*x)) return {};
    }
  }
  return ring.size() < 3 ? std::vector<Point3d>{} : ring;
}

std::vector<std::vector<Point3d>> faces_of_cell(const std::vector<HalfSpace>& half_spaces) {
  std::vector<std::vector<Point3d>> faces;
  for (const HalfSpace& side : half_spaces) {
    const std::vector<Point3d> face = part_of_plane(side, half_spaces);
    // Its corners are counter-clockwise as seen from inside.
    if (!face.empty()) faces.emplace_back(face.rbegin(), face.rend());
  }
  return faces;
}

}  // namespace touchstone::catalogue
