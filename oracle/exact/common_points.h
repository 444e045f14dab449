// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/thin_shapes.h"
#include "oracle/exact/decode.h"

namespace touchstone::oracle {

/// What a thin shape (a segment, or the ray from its a through its b) and a segment have in common, by the exact linear
/// program over the two parameters.
struct CommonPoints {
  bool any = false;
  /// any: the common points with the least and the greatest parameter on the first shape, with their parameters on the
  /// second.
  Rational first, last, second_at_first, second_at_last;
  /// none: normal . p < normal . q for every p of the first shape and q of the second (from the Farkas vector).
  Vector2<Integer> normal;
};

enum class Extent { segment, ray };

/// bits: every |coordinate| < 2^bits. Up to 28 bits the program runs on 128-bit integers.
CommonPoints common_points(const Segment2<Integer>& first, Extent extent, const Segment2<Integer>& second, int bits);

/// A squared length numerator / denominator, the denominator positive.
struct SquaredLength {
  Integer numerator, denominator;
};

/// The squared distance of a point from a segment, or from the ray from its a through its b.
SquaredLength squared_distance(const Point2<Integer>& point, const Segment2<Integer>& shape, Extent extent);

/// The least squared distance of an end of either shape from the other one.
Rational least_end_distance(const Segment2<Integer>& first, Extent extent, const Segment2<Integer>& second);

/// shape.a + t (shape.b - shape.a)
Point2<Rational> point_at(const Segment2<Integer>& shape, const Rational& t);

/// The number halfway between the greatest of normal . p over the first shape and the least over the second; the first
/// shape's direction as in common_points.
Rational halfway(const Vector2<Integer>& normal, const Segment2<Integer>& first, Extent extent,
                 const Segment2<Integer>& second);

}  // namespace touchstone::oracle
