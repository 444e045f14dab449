// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rays.h"

namespace touchstone::reference {

/// Finds the intersection of a closed segment in space and a plane.
///
/// No page of the deck asks this. The formula combines two: p. 22's E(p) = N . p + d, the height over the plane in
/// units of |N|, and, with E0 = E(a) and E1 = E(b), p. 23's
///     t = E0 / (E0 - E1);
/// `point` at a + t (b - a) where 0 <= t <= 1, otherwise `none`.
/// The plane is the thin set N . p + d = 0 and has no solid side: a segment crosses it from either side. segment,
/// plane: the ends and d / |N| in any unit of length, the same for both; N of any length but 0. t is a pure number, 0
/// at a and 1 at b. Closed sets: an end on the plane is a `point`, with t = 0 or t = 1. `inside`: all of the segment
/// lies in the plane, so there is no single t. A segment of length 0 is a point, and so `inside` or `none`.
/// NaN or infinity: refused by robust and oracle (field, "finite number"); so is N = 0 ("plane.normal", "nonzero
/// normal").
///
/// In exact arithmetic the formula is right, except where E0 = E1 = 0: there it is 0/0, and answers `none` instead of
/// `inside` (cause: algorithm).
///
/// Rounding (binary64, to nearest, u = 2^-53): with e(E) the bound of point_plane.h, it is rightly `none` where E0 and
/// E1 have one sign, each exceeds its bound, |E1| > e(E1) + 2u |E0| (else E0 - E1 may round to E0, and t to 1), and
/// |E0| > 2^-1074 |E0 - E1| (else t may round to 0). It is rightly `point` where they have different signs and each
/// exceeds its bound. Then t and the point are as good as point_plane_toi.h says of its option 2, unless something
/// overflows.
/// ulps: 17 roundings behind the point (six in each of E0 and E1, their difference, quotient; difference, product,
/// sum).
template <class Real>
LinePlane<Real> segment_plane(const Segment3<Real>& segment, const Plane<Real>& plane) {
  const auto height = [&plane](const Point3<Real>& p) {
    return Real(dot(plane.normal, Vector3<Real>{p.x, p.y, p.z}) + plane.offset);
  };
  const auto& [a, b] = segment;
  const Real e0 = height(a), e1 = height(b);
  const Real t = Real(e0 / Real(e0 - e1));
  if (Real(0) <= t && t <= Real(1)) return {LinePlaneRelation::point, t, a + t * (b - a)};
  return {LinePlaneRelation::none, std::nullopt, std::nullopt};
}

}  // namespace touchstone::reference
