// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "geometry/space.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The velocity of a particle after it bounced off a plane and lost speed: its component along the normal is multiplied
/// by -k, whether the particle approaches or recedes, and the tangential component stays.
///
/// k is any finite number: 1 is reflect_plane, 0 leaves the part along the plane, -1 the velocity as it is. The normal
/// may have any length but 0, and point to either side. Every component is the double nearest to the exact one, for all
/// finite doubles in every floating-point environment; beyond the range it is infinite, and zero is +0. NaN and
/// infinities throw InvalidInput, which names the field and "finite number"; so does a normal of length 0 ("nonzero
/// normal"). Contract: reference/response/damped_reflection.h.
Vector3d damped_reflection(const Vector3d& velocity, const Vector3d& normal, double k);

namespace stages {

/// There is no filter: numbers have to be computed. Their degree is 6, too high for the lattice.
struct damped_reflection : Signatures<decltype(robust::damped_reflection)> {
  static Partial enclosed;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
