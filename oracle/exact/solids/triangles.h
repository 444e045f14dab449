// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/triangles.h"
#include "oracle/exact/numbers/wide.h"

/// Segments and triangles of space in integers.
namespace touchstone::oracle {

/// A common point: its parameter on the segment, and weights of the triangle's corners that give it.
struct CommonPoint {
  Rational t;
  std::array<Rational, 3> weights;
};

/// The plane normal . p = offset.
struct WitnessPlane {
  Vector3<Integer> normal;
  Rational offset;

  /// Made with the smallest integers of this direction, which certificates print.
  static WitnessPlane of(const Vector3<Integer>& normal, const Rational& offset);
};

/// The intersection of a segment and a triangle, by the exact linear program over the weights of the segment's two ends
/// and of the triangle's three corners.
struct CommonPart {
  CommonPart(const Segment3<Integer>& segment, const Triangle3<Integer>& triangle);

  bool any = false;
  /// any: the common points with the least and the greatest t, any two of a segment of length 0.
  CommonPoint first, last;
  /// none: normal . p > offset on the segment, < offset on the triangle (from the Farkas vector).
  WitnessPlane between;
};

/// segment.a + t (segment.b - segment.a)
Point3<Rational> point_at(const Segment3<Integer>& segment, const Rational& t);

/// A plane through the segment's point at t, with the end segment.a in front of it and no part of the triangle: nothing
/// before t is common. It exists if t > 0 is the least parameter of a common point: another linear program.
WitnessPlane plane_at_first(const Segment3<Integer>& segment, const Triangle3<Integer>& triangle, const Rational& t);

/// The least squared distance of an end of the segment from the triangle, or of the segment from an edge: the squared
/// distance of the two if they have nothing in common.
Rational squared_distance_to_touch(const Segment3<Integer>& segment, const Triangle3<Integer>& triangle);

}  // namespace touchstone::oracle
