// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/answers.h"

namespace touchstone::reference {

/// Decides on which side of a plane a point of space lies, and how far from it.
///
/// Deck p. 22:
///     E(p) = N . p + d,  distance = E / |N|;
/// front where E > 0, back where E < 0, on where E = 0. The signed distance is so divided, with |N| = sqrt(N . N),
/// because the normal need not have length 1. plane: the points with N . p + d = 0; N of any length but 0. point and d
/// / |N|: any unit of length, the same for both. The answer's signed_distance is in that unit, positive in front.
/// Closed set: `on` means exactly on the plane, however near the others are. NaN or infinity: refused by robust and
/// oracle (field, "finite number"); so is N = 0 ("plane.normal", "nonzero normal").
///
/// Rounding (binary64, to nearest, u = 2^-53): with X, Y, Z the three products and E as computed, E is off by at most
///     e(E) = (4 + 16u) u (|X| + |Y| + |Z| + |d|) + 2^-1073
/// unless something overflows: each product rounds and goes through up to three sums, each of which rounds, (1 + u)^4 -
/// 1 over 1 - u is below (4 + 16u) u, and gradual underflow costs half of 2^-1074 a product. Beyond that margin the
/// side is right. With Q = N . N and L = sqrt(Q) as computed and 2^-960 <= Q < infinity, Q is off by a factor of at
/// most (1 + u)^3 (and 2^-114 for squares that underflow), so L is off by 3u relatively, and the distance D by at most
/// (1 + 8u) e(E) / L + 5u |D| + 2^-1074. Outside that range of Q the formula divides by 0, by infinity or by a root of
/// few digits: nothing is promised of D then. In exact arithmetic the formula is always right. ulps: 13 roundings
/// behind the distance (three products and three sums in E, three and two in Q, root, quotient).
template <class Real>
PointPlane<Real> point_plane(const Plane<Real>& plane, const Point3<Real>& point) {
  using std::sqrt;
  const Vector3<Real>& n = plane.normal;
  const Real e = Real(dot(n, Vector3<Real>{point.x, point.y, point.z}) + plane.offset);
  const Real distance = Real(e / Real(sqrt(dot(n, n))));
  return {e > Real(0) ? PlaneSide::front : e < Real(0) ? PlaneSide::back : PlaneSide::on, distance};
}

}  // namespace touchstone::reference
