// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "oracle/exact/solids/triangles.h"

namespace touchstone::oracle {

/// The dimension of the intersection of two triangles, -1 if it is empty.
///
/// As long as there is a plane with normal . p <= offset on one triangle and >= on the other, and a corner off it (an
/// exact linear program), what is common lies in the plane, so that only the corners in the plane matter. Where no
/// corner is left of one, nothing is common. Where no such plane is left, points inside of what is left of both meet
/// (the separation theorem for relative interiors), and the common part has the dimension of the common part of the
/// planes, lines or points that they span.
struct CommonDimension {
  CommonDimension(const Triangle3<Integer>& a, const Triangle3<Integer>& b);

  int dimension;
  std::vector<WitnessPlane> planes;  ///< one after the other; normal . p <= offset for the remaining corners of a
};

/// A common point by weights of the corners of each.
struct PointOfBoth {
  std::array<Rational, 3> on_a, on_b;
};

/// One common point more than the dimension, affinely independent: the least and the greatest along the axes, or
/// perpendicular to those found, by the linear program over the six weights.
std::vector<PointOfBoth> points_of_both(const Triangle3<Integer>& a, const Triangle3<Integer>& b, int dimension);

}  // namespace touchstone::oracle
