// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "oracle/exact/numbers/space.h"
#include "oracle/exact/shapes/nearest_pair.h"
#include "oracle/exact/shapes/whole_cloud.h"
#include "oracle/exact/solids/solid.h"

namespace touchstone::oracle {

/// The point of a triangle that is nearest to another, in units, and the weights of the corners that give it.
struct NearPlace {
  std::size_t triangle;
  Point3<Rational> point;
  std::vector<Rational> weights;
};

/// A closed mesh and a point in integers, times one unit, and how near its surface is, by feet of perpendiculars.
struct PointAndSurface {
  /// The point is the last of the cloud.
  PointAndSurface(IntegerCloud cloud, const std::vector<Face>& faces);

  Point3<Rational> vertex(Index i) const;
  Point3<Rational> actual(const Point3<Rational>& p) const;
  /// The points of all triangles that are as near as the surface, in the order of the triangles. A triangle whose box
  /// is farther away is left out; each other one is solved by nearest_pair.h, and must be no nearer.
  std::vector<NearPlace> nearest() const;

  Rational unit;
  Point3<Rational> point;
  Solid solid;
  Rational square;

 private:
  Hull corners(std::size_t triangle) const;
  bool box_is_beyond(const Hull& hull) const;
};

/// The first of them in lexicographic order.
const NearPlace& first_of(const std::vector<NearPlace>& places);

}  // namespace touchstone::oracle
