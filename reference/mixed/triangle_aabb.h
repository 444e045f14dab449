// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/triangles.h"
#include "geometry/volumes.h"

namespace touchstone::reference {

/// Decides whether a triangle and an axis-aligned box overlap, only touch, or neither.
///
/// No page of the deck asks this. The formula is the textbooks' test of separating axes, as p. 27's boxes of any
/// orientation need it: p. 45-47's box is moved so that its center is the origin, and then both are projected on 13
/// axes: the three edges of the box, the normal of the triangle (p. 21), and the nine cross products of an edge of the
/// box and one of the triangle (p. 54 has edges that cross). With h half of the box's extents, the box reaches from -r
/// to r along n, r = sum |n_k| h_k: they are disjoint where, for an n, the least n . p of the triangle's corners is
/// greater than r, or the greatest is less than -r. On equality, on which textbooks differ, it answers `touching`.
/// triangle, aabb: any unit of length, the same for both. Closed sets: they meet where the triangle has a point of the
/// box, its boundary included. A triangle has no interior: `overlapping` where it has an interior point of the box,
/// `touching` where it has a point of the box and none of its interior. A triangle within the interior overlaps the
/// box; one in the plane of a face, however large, only touches it.
/// A triangle without area is the segment or the point that its corners span, and overlaps the box as any other does.
/// min == max on an axis is valid: such a box is flat and has no interior, and the truth is `touching` at most: also
/// where the triangle goes through it.
/// NaN or infinity: refused by robust and oracle (field "triangle[0][0]", "aabb.min[0]" ..., "finite number"); so is
/// min > max ("aabb.max[0]" ..., "min <= max").
///
/// The truth by axes: the differences of points of the box and of the triangle make a convex solid M. They meet exactly
/// if the origin is in M; and if the box is not flat, they overlap exactly if it is in the interior of M. A face of M
/// is a face of the box, the triangle, or an edge of each that are not parallel, moved by a point of the other; so its
/// normal is one of the 13 axes, and an axis that is zero spans no face. Where the box is flat, M may lie in a plane or
/// in a line: then axes that are perpendicular to all of it are among the 13, as many as there are dimensions missing;
/// and for every edge d of M one that is perpendicular to d and not to all of M: the cross products of d and the edges
/// of the box span all that is perpendicular to d, and so do the edges of the box that are not d. So no other axis is
/// needed: disjoint where one of the 13 separates, otherwise touching where the box is flat, or where they only touch
/// along an axis that is not zero, otherwise overlapping.
///
/// In exact arithmetic the formula is right where the triangle has an area, none of its edges is parallel to an axis,
/// and the box is not flat; and always where the truth is disjoint. Otherwise axes are zero, and along these both reach
/// equally far: of shapes that meet the answer is then `touching`. Along a flat box's own axis nothing tells that it
/// has no interior: where the triangle goes through it, and no axis is zero, the answer is `overlapping` (cause:
/// algorithm).
///
/// Rounding (binary64, to nearest, u = 2^-53): for an axis n let N_k be the sum of the magnitudes of the products of
/// the triangle's edges in its coordinate k, or that coordinate's magnitude, S_k the greatest |coordinate k| of the
/// triangle plus that of the box, and Q = sum N_k S_k, all exactly. A product in n . p goes through two differences, a
/// product and a difference in n, a sum and a difference in p, of which the sum counts for S_k, itself and two sums:
/// nine roundings; one in the reach through fewer. So both sides together are off by at most 2 ((1 + u)^9 - 1) Q < (18
/// + 73u) u Q, and where products or halves underflow by 2^-1071 (sum N_k + sum S_k + 1) more; the comparison is exact.
/// So where the two sides of both comparisons differ by more than that on every axis, unless something overflows, the
/// double version answers as exact arithmetic does. An axis that is zero is never that certain. No number is returned.
template <class Real>
Contact triangle_aabb(const Triangle3<Real>& triangle, const Aabb3<Real>& aabb) {
  const auto& [min, max] = aabb;
  const auto half = [](const Real& x) { return Real(x / Real(2)); };
  const Point3<Real> center{half(Real(min.x + max.x)), half(Real(min.y + max.y)), half(Real(min.z + max.z))};
  const Vector3<Real> h{half(Real(max.x - min.x)), half(Real(max.y - min.y)), half(Real(max.z - min.z))};
  const Vector3<Real> a = triangle.a - center, b = triangle.b - center, c = triangle.c - center;
  const auto magnitude = [](const Real& x) { return x < Real(0) ? Real(Real(0) - x) : x; };
  bool touching = false;
  const auto separates = [&](const Vector3<Real>& n) {
    // Not by std::minmax, whose order is undefined where one is not a number.
    const Real first = dot(n, a), second = dot(n, b), third = dot(n, c);
    Real least = second < first ? second : first, greatest = second < first ? first : second;
    if (third < least) least = third;
    else if (!(third < greatest)) greatest = third;
    const Real reach = Real(magnitude(n.x) * h.x + magnitude(n.y) * h.y + magnitude(n.z) * h.z);
    const Real opposite = Real(Real(0) - reach);
    if (least == reach || greatest == opposite) touching = true;
    return least > reach || greatest < opposite;
  };
  const Real one(1), zero(0);
  const Vector3<Real> x{one, zero, zero}, y{zero, one, zero}, z{zero, zero, one};
  const Vector3<Real> ab = triangle.b - triangle.a, bc = triangle.c - triangle.b, ca = triangle.a - triangle.c;
  for (const Vector3<Real>* edge : {&ab, &bc, &ca})
    for (const Vector3<Real>* axis : {&x, &y, &z})
      if (separates(cross(*axis, *edge))) return Contact::disjoint;
  for (const Vector3<Real>* axis : {&x, &y, &z})
    if (separates(*axis)) return Contact::disjoint;
  if (separates(cross(ab, bc))) return Contact::disjoint;
  return touching ? Contact::touching : Contact::overlapping;
}

}  // namespace touchstone::reference
