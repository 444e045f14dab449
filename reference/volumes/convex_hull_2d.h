// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/answers.h"

namespace touchstone::reference {

/// The cosine of the angle between two vectors times its own size: greater for the smaller of two angles, 0 at a right
/// angle. Without a root and an arc cosine it is exact wherever arithmetic is. 0 / 0 if a vector has length zero.
template <class Real, class Vector>
Real squared_cosine(const Vector& v, const Vector& w) {
  const Real product = dot(v, w), size = product < Real(0) ? Real(-product) : product;
  return Real(Real(product * size) / Real(dot(v, v) * dot(w, w)));
}

/// The convex hull of points in the plane: its extreme points counter-clockwise, by their indices in the list.
///
/// Deck p. 35-42: gift wrapping, in the plane. The highest point (y is up; of several the first) comes first. From
/// there the next is the one that makes the smallest angle with the horizontal, from the others on the one that makes
/// the smallest angle with the edge before, until that is the first one again. Angles are compared by their cosines.
/// The slide does not say which of several points in one direction comes next: it is the first in the list. A walk
/// that has not closed after as many points as there are is given up.
///
/// points: at least one, any unit of length. The answer has dimension 0 (all points are equal: `point`), 1 (they lie
/// on one line: `segment`, its ends in either order) or 2 (`polygon`). A vertex is an extreme point: one that lies on
/// no segment between two others. Points inside an edge are none, and of equal points one alone is listed. Any first
/// vertex, and any of equal points, is right.
/// Refused by robust and oracle: NaN or infinity (points[i][k], "finite number"), an empty list (points, "at least 1
/// point").
///
/// Rounding (binary64, to nearest, u = 2^-53): with all differences of coordinates 0 or between 2^-200 and 2^200 in
/// magnitude the computed value is off by at most 20u: the dot product by 4u |v| |w|, its square by 9u |v|^2 |w|^2
/// (two of those and a rounding), the divisor by a factor of 1 + 9u (four roundings for each square of a length, one
/// for their product), the quotient by one rounding, and u is left for terms of u^2. So the answer is right where no
/// other point is as high as the first one and where, at each vertex of the hull, the next one's value exceeds that of
/// every other point by more than 40u: points in the direction of an edge are beyond that promise even where they lie
/// on it exactly, and an angle of 1e-8 is taken for 0.
/// Where points lie inside an edge, or several are highest, the formula may list them, or pass by its first point and
/// never close (cause: algorithm); otherwise it is right in exact arithmetic.
template <class Real>
ConvexHull2 convex_hull_2d(const std::vector<Point2<Real>>& points) {
  Index first = 0;
  for (Index i = 1; i < points.size(); ++i) {
    if (points[i].y > points[first].y) first = i;
  }
  std::vector<Index> ring{first};
  Vector2<Real> before{Real(-1), Real(0)};
  while (ring.size() <= points.size()) {
    const Point2<Real>& from = points[ring.back()];
    Index next = first;
    Real greatest(-2);
    for (Index i = 0; i < points.size(); ++i) {
      const Real cosine = squared_cosine<Real>(before, points[i] - from);
      if (cosine > greatest) next = i, greatest = cosine;
    }
    if (next == first) break;
    before = points[next] - from;
    ring.push_back(next);
  }
  if (ring.size() == 1) return {0, ring[0], {}, {}};
  if (ring.size() == 2) return {1, {}, IndexPair{ring[0], ring[1]}, {}};
  return {2, {}, {}, ring};
}

}  // namespace touchstone::reference
