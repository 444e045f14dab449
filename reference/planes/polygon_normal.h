// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/answers.h"

namespace touchstone::reference {

/// The normal of a polygon in space, and the same of length 1.
///
/// Deck p. 21:
///     N = (v1 - v0) x (v2 - v1),
/// the cross product of two edges, divided by its length sqrt(N . N). polygon: at least three vertices, any unit of
/// length. The truth's `normal` is Newell's sum over the ring, sum of v_i x v_(i+1): twice the vector of the polygon's
/// area, so that it does not depend on which vertex is the first and belongs to the entire ring, even if that is
/// concave, crosses itself or is not planar; seen from its tip a simple planar ring runs counter-clockwise. `unit` is
/// that sum divided by its length. `degenerate`: the sum is the zero vector (collinear or coincident vertices; a figure
/// of eight whose two parts cancel); then there are no numbers. A coordinate of `normal` may be infinite, beyond the
/// range of doubles, or 0 below it: `unit` is right all the same. NaN or infinity: refused by robust and oracle (field,
/// "finite number"); so are fewer than three vertices ("polygon", "at least 3 vertices"). A last position that repeats
/// the first changes nothing, and is no vertex of the three.
///
/// The slide uses three vertices. For a triangle that is Newell's sum. For every other ring the length is another
/// one, so the formula leaves `normal` out and answers `unit` alone; and the direction, or whether there is one, is
/// another one too where the corner at v1 is reflex (the opposite direction), flat or a repetition (`degenerate`), and
/// where the ring is not planar. All these are wrong in exact arithmetic too (cause: algorithm).
///
/// Rounding (binary64, to nearest, u = 2^-53): with L and R the two products in a coordinate of N as computed, the
/// coordinate is off by at most (4 + 20u) u (|L| + |R|) + 2^-1073 (see orientation.h, and the subtraction's own
/// rounding); let D be the sum of these three bounds. With Q = N . N and s = sqrt(Q) as computed and 2^-960 <= Q <
/// infinity, and nothing else overflowing, s is the length of the computed N except for 3u relatively. So a coordinate
/// U of the unit normal of the first three vertices is off by at most
///     5u |U| + (2 + 8u) D / s + 2^-1074
/// and `proper` is right for these three where (1 - 4u) s > D.
/// ulps: 22 roundings behind each coordinate (six differences, nine in the cross product, five in Q, root, quotient).
template <class Real>
PolygonNormal<Real> polygon_normal(const Polygon3<Real>& polygon) {
  using std::sqrt;
  const Vector3<Real> n = cross(polygon[1] - polygon[0], polygon[2] - polygon[1]);
  const Real length = Real(sqrt(dot(n, n)));
  if (length == Real(0)) return {NormalClass::degenerate, std::nullopt, std::nullopt};
  return {NormalClass::proper, std::nullopt, Vector3<Real>{Real(n.x / length), Real(n.y / length), Real(n.z / length)}};
}

}  // namespace touchstone::reference
