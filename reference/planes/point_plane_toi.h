// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"

namespace touchstone::reference {

/// Decides whether a point that moves from start to end in one step hits a plane, by the two options of the slide.
///
/// Deck p. 23: with E(p) = N . p + d (point_plane.h), option 1 tests the end of the step only: hit where E(end) <= 0.
/// Option 2 finds when the plane was reached,
///     t = E0 / (E0 - E1),
/// E0 and E1 being E at start and end; hit where 0 <= t <= 1, at start + t (end - start). plane, start, end: any unit
/// of length, the same for all; t counts in steps. Solid is the closed half-space E <= 0, so touching is a hit. The
/// truth of option 2 is the first t in [0, 1] with E <= 0: 0, and the point start itself, where the start is on the
/// plane or behind it already; t and point as by the formula where the start is in front and the end is not; `never`
/// where both are in front. So option 1 can only miss what option 2 finds: a point that starts behind the plane and
/// leaves. start == end is valid: hit at 0 or never. NaN or infinity: refused by robust and oracle (field, "finite
/// number"); so is N = 0 ("plane.normal", "nonzero normal").
///
/// The formula assumes that the start is in front. From behind the plane it finds no t in [0, 1], or the t where the
/// point leaves the solid; within the plane it is 0/0: wrong in exact arithmetic too (cause: algorithm).
///
/// Rounding (binary64, to nearest, u = 2^-53): with e(E) the bound of point_plane.h, option 1 is right where |E1| >
/// e(E1). Option 2 is rightly `never` where E0 > e(E0), E1 > e(E1) + 2u E0 (else E0 - E1 may round to E0, and t to 1)
/// and E0 > 2^-1074 |E0 - E1| (else t may round to 0), rightly `hit` where E0 > e(E0) and E1 < -e(E1). Then, with F =
/// E0 - E1 as computed and f = e(E0) + e(E1) + u F < F, t is off by at most
///     e(t) = (e(E0) + t f) / (F - f) + 2u t + 2^-1074
/// and a coordinate X of the point, with V of end - start as computed, by at most (1 + 2u) |V| e(t) + 3u t |V| + u |X|
/// + 2^-1073, unless something overflows. ulps: 17 roundings behind the point (six in each of E0 and E1, their
/// difference, quotient; difference, product, sum).
template <class Real>
PointPlaneToi<Real> point_plane_toi(const Plane<Real>& plane, const Point3<Real>& start, const Point3<Real>& end) {
  const auto height = [&plane](const Point3<Real>& p) {
    return Real(dot(plane.normal, Vector3<Real>{p.x, p.y, p.z}) + plane.offset);
  };
  const Real e0 = height(start), e1 = height(end);
  const StepTest option_1{e1 <= Real(0) ? HitRelation::hit : HitRelation::never};
  const Real t = Real(e0 / Real(e0 - e1));
  if (Real(0) <= t && t <= Real(1)) return {option_1, {HitRelation::hit, t, start + t * (end - start)}};
  return {option_1, {HitRelation::never, std::nullopt, std::nullopt}};
}

}  // namespace touchstone::reference
