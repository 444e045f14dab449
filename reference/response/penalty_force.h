// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/space.h"

namespace touchstone::reference {

/// The force on a particle that has got behind a plane: a spring that pulls it back, and a damper.
///
/// Deck p. 72-73: with E(p) = N . p + d, while E < 0 the spring's force is -k E / |N| along N / |N| and the damper's
/// -c (v . N) / |N| along N / |N|, so together
///     f = -((k E + c v . N) / (N . N)) N,
/// without a square root; where E >= 0, on the plane too, the force is 0. The damper acts in both directions: it also
/// slows a particle that is leaving, and the sum may pull it towards the plane's back. point and d / |N|: any unit of
/// length. velocity: that unit a unit of time. N: of any length but 0. stiffness k, damping c: units of force per unit
/// of length and of velocity. The slide names no limits for k and c, and the formula has a meaning for all of them:
/// none but a number that is not finite is refused; a negative one pushes where the other pulls. NaN or infinity:
/// refused by robust and oracle (field, "finite number"); so is N = 0 ("plane.normal", "nonzero normal").
///
/// Rounding (binary64, to nearest, u = 2^-53), where every number is 0 or between 2^-100 and 2^100 in size, so that
/// nothing overflows or underflows: with SE = |Nx px| + |Ny py| + |Nz pz| + |d| and SV = |Nx vx| + |Ny vy| + |Nz vz|, E
/// is off by less than 5u SE, so beyond that it is decided rightly whether there is a force, and then component i is
/// off by at most
///     (12 (|k| SE + |c| SV) / N . N) |N_i| u.
/// E is off by 4u SE and v . N by 3u SV, to first order, the products with k and c by one more, N . N by 3u relatively,
/// the quotients, their sum and its product with N_i by one each: 11, and one for what is of higher order. In exact
/// arithmetic the formula is always right.
/// ulps: 22 roundings behind each component (six in E, five in v . N, five in N . N, two products, two quotients, sum,
/// product).
template <class Real>
Vector3<Real> penalty_force(const Point3<Real>& point, const Vector3<Real>& velocity, const Plane<Real>& plane,
                            const Real& stiffness, const Real& damping) {
  const Vector3<Real>& n = plane.normal;
  const Real e = Real(dot(n, Vector3<Real>{point.x, point.y, point.z}) + plane.offset);
  if (!(e < Real(0))) return {Real(0), Real(0), Real(0)};
  const Real square = dot(n, n);
  const Real spring = Real(Real(stiffness * e) / square), damper = Real(Real(damping * dot(velocity, n)) / square);
  return Real(-Real(spring + damper)) * n;
}

}  // namespace touchstone::reference
