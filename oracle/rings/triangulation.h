// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/polygons.h"
#include "oracle/exact/decode.h"

/// Triangulations and partitions of simple rings, on integers.
namespace touchstone::oracle {

/// Lists of places in a ring.
using IndexLists = std::vector<std::vector<Index>>;

/// A ring in integers, each times one positive unit.
class WholePolygon {
 public:
  explicit WholePolygon(const Polygon2d& ring);
  explicit WholePolygon(const Polygon2<Rational>& ring);

  Index size() const { return static_cast<Index>(points_.size()); }
  const Point2<Integer>& operator[](Index i) const { return points_[i]; }
  Index after(Index i) const { return i + 1 == size() ? 0 : i + 1; }
  Index before(Index i) const { return i == 0 ? size() - 1 : i - 1; }

  /// Twice the area of the triangle, positive where it turns left, in squares of the unit.
  Integer area(Index i, Index j, Index k) const { return cross(points_[j] - points_[i], points_[k] - points_[i]); }
  int turn(Index i, Index j, Index k) const { return sgn(area(i, j, k)); }
  /// Twice the area, positive counter-clockwise, of the ring through these vertices.
  Integer area(const std::vector<Index>& piece) const;
  Integer area() const;

  /// value * unit^2
  Rational actual_area(const Integer& value) const;

 private:
  std::vector<Point2<Integer>> points_;
  Rational unit_;
};

/// Refuses what is not a simple polygon.
void admit_simple(const Polygon2d& polygon);
void admit_simple(const Polygon2<Rational>& polygon);

/// The ring's vertices counter-clockwise.
std::vector<Index> counter_clockwise(const WholePolygon& ring);

/// A triangulation of a simple ring, diagonal by diagonal.
IndexLists triangulated(const WholePolygon& ring);

/// The least size of twice the area of three consecutive vertices, in squares of the unit of the input.
Rational least_turn(const WholePolygon& ring);

/// What is wrong with the claim that these convex counter-clockwise pieces are a simple polygon, cut along diagonals; "" if it is right.
std::string partition_fault(const Polygon2d& polygon, const IndexLists& pieces);

}  // namespace touchstone::oracle
