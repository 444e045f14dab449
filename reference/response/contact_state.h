// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bodies.h"

namespace touchstone::reference {

/// The velocity of a point of a rotating body: v + w x (p - position).
template <class Real>
Vector3<Real> velocity_at(const MovingBody<Real>& body, const Point3<Real>& point) {
  return body.velocity + cross(body.angular_velocity, point - body.position);
}

/// Decides whether two bodies that touch at a point part there, stay, or collide.
///
/// Deck p. 74: with the velocities of both bodies at the contact, v + w x (p - position), the sign of the relative
/// normal velocity
///     c = n . (va(p) - vb(p)):
/// positive is `separating`, 0 `resting`, negative `colliding`. normal: from b to a, of any length but 0. positions,
/// point: any unit of length. velocities: that unit a unit of time; angular velocities: radians a unit of time, around
/// the body's own position. Bodies that slide along each other, or roll, are `resting`: nothing is said of what is
/// across the normal. It is not tested whether they touch at the point.
/// `resting` means exactly 0, however slow others are. NaN or infinity: refused by robust and oracle (field, "finite
/// number"); so is n = 0 ("normal", "nonzero normal").
///
/// Rounding (binary64, to nearest, u = 2^-53), where every number is 0 or between 2^-100 and 2^100 in size, so that
/// nothing overflows or underflows: a product of three goes through at most eight roundings (the difference in p -
/// position, two products, the differences in the cross product and of both velocities, three sums), so the relative
/// normal velocity is off by at most
///     9u S, S = |nx| Sx + |ny| Sy + |nz| Sz,
/// where Sx is the sum of the magnitudes of vx and of both products in (w x (p - position)).x, over both bodies, taken
/// exactly, and so on; (1 + u)^8 - 1 < 9u. Beyond that margin the state is right. In exact arithmetic it always is.
template <class Real>
ContactState contact_state(const MovingBody<Real>& a, const MovingBody<Real>& b, const Point3<Real>& point,
                           const Vector3<Real>& normal) {
  const Real apart = dot(normal, velocity_at(a, point) - velocity_at(b, point));
  return apart > Real(0) ? ContactState::separating : apart < Real(0) ? ContactState::colliding : ContactState::resting;
}

}  // namespace touchstone::reference
