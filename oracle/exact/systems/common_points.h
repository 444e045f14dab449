// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/thin_shapes.h"
#include "oracle/exact/numbers/wide.h"

namespace touchstone::oracle {

enum class Extent { segment, ray };

/// numerator / denominator, the denominator positive.
template <class Value>
struct Fraction {
  Value numerator, denominator;
};

template <class Value>
Rational rational(const Fraction<Value>& t) {
  return quotient(t.numerator, t.denominator);
}

/// The intersection of a thin shape (a segment, or the ray from its a through its b) and a segment, by the exact linear
/// program over the two parameters. Value: Integer, or Int128 if every |coordinate| < 2^61 (a minor of the program is a
/// sum of at most four products of two differences).
template <class Value>
struct CommonPoints {
  CommonPoints(const Segment2<Value>& first_shape, Extent extent, const Segment2<Value>& second_shape);

  bool any = false;
  /// any: the common points with the least and the greatest parameter on the first shape, with their parameters on the
  /// second; `extended` if they differ.
  Fraction<Value> first, last, second_at_first, second_at_last;
  bool extended = false;
  /// none: normal . p < normal . q for every p of the first shape and q of the second (from the Farkas vector).
  Vector2<Value> normal;
};

/// A squared length numerator / denominator, the denominator positive.
template <class Value>
struct SquaredLength {
  decltype(product(Value(), Value())) numerator;
  Value denominator;
};

bool operator<(const SquaredLength<Integer>& a, const SquaredLength<Integer>& b);
bool operator<(const SquaredLength<Int128>& a, const SquaredLength<Int128>& b);

/// The squared distance of a point from a segment, or from the ray from its a through its b.
template <class Value>
SquaredLength<Value> squared_distance(const Point2<Value>& point, const Segment2<Value>& shape, Extent extent);

/// The least squared distance of an end of either shape from the other one.
template <class Value>
Rational least_end_distance(const Segment2<Value>& first, Extent extent, const Segment2<Value>& second);

/// shape.a + t (shape.b - shape.a)
template <class Value>
Point2<Rational> point_at(const Segment2<Value>& shape, const Rational& t);

/// The number halfway between the greatest of normal . p over the first shape and the least over the second; the first
/// shape's direction as in CommonPoints.
template <class Value>
Rational halfway(const Vector2<Value>& normal, const Segment2<Value>& first, Extent extent,
                 const Segment2<Value>& second);

}  // namespace touchstone::oracle
