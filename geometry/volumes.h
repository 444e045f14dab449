// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/points.h"
#include "geometry/polygons.h"
#include "geometry/space.h"

namespace touchstone {

/// The closed box of points with min <= p <= max in each coordinate. min == max in one of them is valid: a flat box,
/// which has no interior. min > max is refused.
template <class Real>
struct Aabb2 {
  Point2<Real> min, max;
};
template <class Real>
struct Aabb3 {
  Point3<Real> min, max;
};

/// The closed ball |p - center| <= radius. Radius 0 is valid (a point, which has no interior); a negative radius is
/// refused.
template <class Real>
struct Sphere3 {
  Point3<Real> center;
  Real radius;
};

/// The places of two elements of one list.
struct IndexPair {
  Index i, j;
  friend bool operator==(const IndexPair&, const IndexPair&) = default;
};

using Aabb2d = Aabb2<double>;
using Aabb3d = Aabb3<double>;
using Sphere3d = Sphere3<double>;

}  // namespace touchstone
