// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/space.h"
#include "oracle/exact/numbers/decode.h"

/// Balls around points with integer coordinates.
namespace touchstone::oracle {

using IntegerPoints = std::vector<Point3<Integer>>;

/// center = times / d, d > 0; the radius is the root of square / d^2.
struct IntegerBall {
  Point3<Integer> times;
  Integer d, square;

  /// |p - center|^2 d^2
  Integer squared_distance(const Point3<Integer>& p) const;
  /// The first of the points that are farthest from the center.
  std::size_t farthest(const IntegerPoints& points) const;
};

/// The ball around a center that reaches the farthest point.
IntegerBall reaching_farthest(const Point3<Integer>& times, const Integer& d, const IntegerPoints& points);

/// The smallest ball: its center is the sum of weights[i] / d times the point support[i]; the weights are positive, and
/// their sum is d.
struct SmallestBall : IntegerBall {
  std::vector<std::size_t> support;
  std::vector<Integer> weights;
};
SmallestBall smallest_ball(const IntegerPoints& points);

/// Ritter's ball in units of 2^-below: center.times / d, and its radius, not less than that of the definition.
struct GrowingBall {
  Point3<Integer> center;
  Integer radius;
};
GrowingBall growing_ball(const IntegerPoints& points, unsigned below);

}  // namespace touchstone::oracle
