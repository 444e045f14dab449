// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/space.h"

namespace touchstone::reference {

/// The velocity of a particle after it bounced off a plane with that normal and lost a part of its speed along it.
///
/// Deck p. 71: as reflect_plane,
///     u = (v . n / (n . n)) n,  w = v - u,  v' = w - k u.
/// k is a number without unit, 0.8 on the slide: 1 is reflect_plane, 0 leaves the part along the plane alone, and -1
/// the velocity as it is. The slide names no limits, and the formula has a meaning for every k: none but a number that
/// is not finite is refused. A k above 1 gains speed, a negative one lets the particle through. velocity: any unit.
/// normal: of any length but 0, on either side of the plane. It does not matter whether the particle approaches or
/// recedes.
/// NaN or infinity: refused by robust and oracle (field, "finite number"); so is n = 0 ("normal", "nonzero normal").
///
/// Rounding (binary64, to nearest, u = 2^-53), where every number is 0 or between 2^-100 and 2^100 in size, so that
/// nothing overflows or underflows: with S = |vx nx| + |vy ny| + |vz nz| and r = S / (n . n), component i is off by at
/// most
///     (11 (1 + |k|) r |n_i| + 3 |v_i|) u.
/// u_i is off by 8u r |n_i| (reflect_plane.h), so k u_i, which rounds, by 9u |k| r |n_i|; the differences round with
/// u (|v_i| + r |n_i|) and u (|v_i| + (1 + |k|) r |n_i|): together 10 (1 + |k|) and 2, and one of each for what is of
/// higher order. In exact arithmetic the formula is always right.
/// ulps: 15 roundings behind each component (the 14 of reflect_plane, and k u).
template <class Real>
Vector3<Real> damped_reflection(const Vector3<Real>& velocity, const Vector3<Real>& normal, const Real& k) {
  const Vector3<Real> along = Real(dot(velocity, normal) / dot(normal, normal)) * normal;
  const Vector3<Real> across = velocity - along;
  return across - k * along;
}

}  // namespace touchstone::reference
