// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rays.h"

namespace touchstone::reference {

/// Finds the intersection of a ray and a closed triangle in space.
///
/// No page of the deck asks this. The formula is p. 54's for an edge and a face, with p. 9's ray instead of the edge:
/// with the normal N = (b - a) x (c - a), E0 = N . (origin - a) and the rise R = N . direction,
///     t = -E0 / R,  x = origin + t direction,
/// and `point` where 0 <= t and ((b - a) x (x - a)) . N and the same of the edges b, c and c, a are all >= 0; otherwise
/// `none`.
/// ray, triangle: any unit of length, the same for both; t is in units of the direction's length. Closed sets: the
/// origin, edges and corners belong to them, so a touch is a `point`. `segment`: all of a segment is common, of which t
/// and point are the first. `location` tells a `point` within the triangle from one on its boundary, an edge or a
/// corner: to count crossings of a surface, count those `inside` with t > 0, and cast another ray where a point is on a
/// `boundary`, where a `segment` is common, or where t = 0. The triangle has no solid side: a ray meets it from either.
/// Degenerate: a triangle without area is the segment or the point that its corners span, and has no inside: every
/// point is on its boundary. NaN or infinity: refused by robust and oracle (field, "finite number"); so is a direction
/// of length 0 ("ray.direction", "nonzero direction"). t and the point are infinite if the exact ones are beyond the
/// range of doubles.
///
/// The slide has no case for a ray in the triangle's plane and for a triangle without area: these are `none` even in
/// exact arithmetic (cause: algorithm), and `segment` is never answered. In exact arithmetic it is right about all
/// others.
///
/// Rounding (binary64, to nearest, u = 2^-53): with e(E) the bound of segment_triangle.h, for R with the direction
/// instead of p - a, it is rightly `none` where E0 and R each exceed their bounds, have one sign, and |E0| > 2^-1074
/// |R| (else t may round to 0). Where it is rightly `point`, and both exceed their bounds, t and the point are as good
/// as ray_plane.h says. Nothing is promised of the decision inside or outside of an edge.
/// ulps: 29 roundings behind t (nine differences, twelve products, three differences of the normal, four sums, a
/// quotient), 31 behind each coordinate of the point.
template <class Real>
RayTriangle<Real> ray_triangle(const Ray3<Real>& ray, const Triangle3<Real>& triangle) {
  const RayTriangle<Real> none{SegmentTriangleRelation::none, std::nullopt, std::nullopt, std::nullopt};
  const auto& [a, b, c] = triangle;
  const Vector3<Real> normal = cross(b - a, c - a);
  const Real at_origin = dot(normal, ray.origin - a), rise = dot(normal, ray.direction);
  if (rise == Real(0)) return none;
  const Real t = Real(Real(-at_origin) / rise);
  if (!(Real(0) <= t)) return none;
  const Point3<Real> x = ray.origin + t * ray.direction;
  const auto depth = [&](const Point3<Real>& from, const Point3<Real>& to) {
    return dot(cross(to - from, x - from), normal);
  };
  const Real ab = depth(a, b), bc = depth(b, c), ca = depth(c, a);
  if (!(ab >= Real(0) && bc >= Real(0) && ca >= Real(0))) return none;
  const bool inside = ab > Real(0) && bc > Real(0) && ca > Real(0);
  return {SegmentTriangleRelation::point, t, x, inside ? Location::inside : Location::boundary};
}

}  // namespace touchstone::reference
