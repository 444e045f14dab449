// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"

namespace touchstone::reference {

/// Decides whether a ray meets a closed segment, and where first.
///
/// Deck p. 2, 14: the equations of p. 12 for P0 + t V = a + s (b - a), with t >= 0 and 0 <= s <= 1. With B = b - a, W =
/// a - P0 and the cross product v.x w.y - v.y w.x, Cramer's rule gives
///     D = V x B,  t = (W x B) / D,  s = (W x V) / D;
/// `point` at P0 + t V where 0 <= t and 0 <= s <= 1, otherwise (also where D = 0) `none`. ray, segment: any unit of
/// length, the same for both; t: a pure number, in units of V's length. Closed sets: the ray's origin and both ends of
/// the segment belong to them. `overlap`: a common segment, its ends in order of t, and t that of the first; where the
/// ray and a collinear segment share one point it is a `point`. Degenerate: a segment of length 0 is a point. NaN or
/// infinity: refused by robust and oracle (field, "finite number"); so is a zero direction ("nonzero direction").
///
/// The slide has no case for a segment along the ray: one that lies on it, touches its origin from behind or has length
/// 0 is `none` even in exact arithmetic (cause: algorithm); `overlap` is never answered.
///
/// Rounding (binary64, to nearest, u = 2^-53): as in reference/lines/line_line.h, but V is given and not rounded. With
/// L and R the computed products of a cross product N = L - R, k roundings in each make it off, before its subtraction,
/// by at most
///     d(N) = ((1 + u)^k - 1) (|L| + |R|) + 2^-1073, after it by e(N) = d(N) + u |N|;
/// k = 2 for D and for W x V, where (1 + u)^2 - 1 <= (2 + u) u, and k = 3 for W x B, where (1 + u)^3 - 1 <= (3 + 4u) u.
/// With Q = N / D the exact quotient of the computed N and D, and T the computed one,
///     e(T) = (e(N) + |Q| e(D)) / (|D| - e(D)) + u |T| + 2^-1075   bounds the error of t and s while |D| > e(D).
/// The double version is right when |D| exceeds e(D) and either t < -e(t), or s is outside [0, 1] by more than e(s), or
/// t > e(t) and s is inside and further than e(s) from both 0 and 1, unless something overflows. The point's x is then
/// off by at most
///     |V.x| e(t) + u |P| + u |X| + 2^-1075, with P = t V.x and X = P0.x + P.
/// ulps: 11 roundings behind t (four differences, four products, two subtractions, one quotient), 13 behind each
/// coordinate of the point (a product and a sum more).
template <class Real>
RaySegment<Real> ray_segment(const Ray2<Real>& ray, const Segment2<Real>& segment) {
  const Vector2<Real> along = segment.b - segment.a, w = segment.a - ray.origin;
  const Real den = cross(ray.direction, along);
  if (den == Real(0)) return {RayRelation::none, std::nullopt, std::nullopt, std::nullopt};
  const Real t = Real(cross(w, along) / den), s = Real(cross(w, ray.direction) / den);
  if (Real(0) <= t && Real(0) <= s && s <= Real(1)) {
    return {RayRelation::point, t, ray.origin + t * ray.direction, std::nullopt};
  }
  return {RayRelation::none, std::nullopt, std::nullopt, std::nullopt};
}

}  // namespace touchstone::reference
