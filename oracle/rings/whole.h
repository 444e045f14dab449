// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/polygons.h"
#include "geometry/thin_shapes.h"
#include "oracle/exact/numbers/decode.h"

namespace touchstone::oracle {

/// A ring in integers times one positive unit. Signs and ratios are those of the ring itself.
class IntegerRing {
 public:
  explicit IntegerRing(const Polygon2d& polygon);
  explicit IntegerRing(const Polygon2<Rational>& polygon);

  Index size() const { return static_cast<Index>(ring.size()); }
  const Point2<Integer>& operator[](std::size_t i) const { return ring[i]; }
  Segment2<Integer> edge(std::size_t i) const { return {ring[i], ring.next(i)}; }
  std::vector<Segment2<Integer>> edges() const;
  Index after(Index i) const { return i + 1 == size() ? 0 : i + 1; }
  Index before(Index i) const { return i == 0 ? size() - 1 : i - 1; }

  /// Twice the area of the triangle of three vertices, positive if it turns left, in squares of the unit; and its sign,
  /// which is faster.
  static Integer area(const Point2<Integer>& p, const Point2<Integer>& q, const Point2<Integer>& r);
  Integer area(Index i, Index j, Index k) const { return area(ring[i], ring[j], ring[k]); }
  int turn(Index i, Index j, Index k) const;
  int turn_at(Index i) const { return turn(before(i), i, after(i)); }

  /// Twice the area, positive counter-clockwise, of the ring through these vertices; of the entire ring.
  Integer area(const std::vector<Index>& piece) const;
  Integer area() const;

  /// Converts a value in squared units.
  Rational actual_area(const Rational& value) const { return Rational(value * unit * unit); }

  Polygon2<Integer> ring;
  Rational unit;
  /// The same integers if all fit 61 bits, so that Int128 holds a difference of two products of differences; otherwise
  /// empty.
  std::vector<Point2<std::int64_t>> words;

 private:
  void find_words();
};

}  // namespace touchstone::oracle
