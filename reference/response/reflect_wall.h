// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"

namespace touchstone::reference {

/// The velocity of a particle after it bounced off a wall that is perpendicular to a coordinate axis, without loss.
///
/// Deck p. 67: the component along that axis is negated, the others stay:
///     v'[axis] = -v[axis];
/// axis x is a wall x = constant.
/// velocity: any unit. It does not matter whether the particle approaches or recedes: the law applies to both. The zero
/// vector is valid. -0.0 is 0.
/// NaN or infinity: refused by robust and oracle (field "velocity[0]" ..., "finite number").
///
/// Rounding: none; a negation is exact, and kinetic energy is kept exactly. So the double version is right for every
/// input.
/// ulps: 0.
template <class Real>
Vector3<Real> reflect_wall(const Vector3<Real>& velocity, Axis axis) {
  Vector3<Real> reflected = velocity;
  switch (axis) {
    case Axis::x: reflected.x = Real(-velocity.x); break;
    case Axis::y: reflected.y = Real(-velocity.y); break;
    case Axis::z: reflected.z = Real(-velocity.z); break;
  }
  return reflected;
}

}  // namespace touchstone::reference
