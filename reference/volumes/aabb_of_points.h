// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/volumes.h"

namespace touchstone::reference {

/// Extends the interval of one coordinate: the number replaces the end that it exceeds. The first one is both ends.
template <class Real>
void extend(Real& min, Real& max, const Real& number, bool first) {
  if (first || number < min) min = number;
  if (first || number > max) max = number;
}

/// The least axis-aligned box that holds all of some points, in the plane or in space.
///
/// Deck p. 28-30: on each axis the least and the greatest coordinate,
///     min[i] = min(p[i]),  max[i] = max(p[i]).
/// points: any unit of length. Closed: points on the boundary are in the box, and on each side lies at least one. One
/// point, or equal points: the box is that point. Points on an axis-parallel line or plane: the box is flat, min == max
/// on an axis, which is valid. The order of the points and how often each is there do not matter.
/// -0.0 is 0: whether it is less than 0.0 or greater is not asked, and a coordinate of 0 in the answer is 0.0 or -0.0
/// (robust: always 0.0).
/// No points: refused by robust and oracle (field "points", "at least 1 point"); so are NaN and infinity (field
/// "points[i][k]", "finite number").
///
/// Rounding: none; every number of the answer is one of the input. So in every environment that does not read
/// subnormals as zero the double version is right for every input.
/// ulps: 0. Nothing is decided: no margin.
template <class Real>
Aabb2<Real> aabb_of_points(const std::vector<Point2<Real>>& points) {
  Aabb2<Real> box{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    extend(box.min.x, box.max.x, points[i].x, i == 0), extend(box.min.y, box.max.y, points[i].y, i == 0);
  }
  return box;
}
template <class Real>
Aabb3<Real> aabb_of_points(const std::vector<Point3<Real>>& points) {
  Aabb3<Real> box{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    extend(box.min.x, box.max.x, points[i].x, i == 0), extend(box.min.y, box.max.y, points[i].y, i == 0);
    extend(box.min.z, box.max.z, points[i].z, i == 0);
  }
  return box;
}

}  // namespace touchstone::reference
