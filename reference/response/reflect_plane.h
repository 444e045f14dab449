// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/space.h"

namespace touchstone::reference {

/// The velocity of a particle after it bounced, without loss, off a plane with that normal.
///
/// Deck p. 68: with u the part of the velocity v along the normal and w the part along the plane
///     u = (v . n / (n . n)) n,  w = v - u,  v' = w - u.
/// velocity: any unit. normal: of any length but 0, and on either side of the plane: n, -n and 7 n are one plane. It
/// does not matter whether the particle approaches or recedes: the law applies to both. A velocity along the plane, the
/// zero vector too, stays what it is; one along the normal is turned round.
/// NaN or infinity: refused by robust and oracle (field "velocity[0]" ..., "finite number"); so is n = 0 ("normal",
/// "nonzero normal").
///
/// Rounding (binary64, to nearest, u = 2^-53), where every number is 0 or between 2^-100 and 2^100 in size, so that
/// nothing overflows or underflows: with S = |vx nx| + |vy ny| + |vz nz| and r = S / (n . n), component i is off by at
/// most
///     (20 r |n_i| + 3 |v_i|) u.
/// v . n is off by 3u S and n . n by 3u relatively, each to first order; so v . n / n . n is off by 7u r and u_i by 8u
/// r |n_i|; it is subtracted twice, and both differences round, with u (|v_i| + r |n_i|) and u (|v_i| + 2 r |n_i|):
/// together 19 and 2, and one of each for what is of higher order. The bound is relative to S, not to v . n: where
/// these cancel (grazing) and n is nearly along an axis, a component has no right digit. In exact arithmetic the
/// formula is always right.
/// ulps: 14 roundings behind each component (three products and two sums in v . n, as many in n . n, quotient, product,
/// two differences).
template <class Real>
Vector3<Real> reflect_plane(const Vector3<Real>& velocity, const Vector3<Real>& normal) {
  const Vector3<Real> along = Real(dot(velocity, normal) / dot(normal, normal)) * normal;
  const Vector3<Real> across = velocity - along;
  return across - along;
}

}  // namespace touchstone::reference
