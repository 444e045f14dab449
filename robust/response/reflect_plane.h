// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "geometry/space.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The velocity of a particle after it bounced, without loss, off a plane: its component along the normal is reversed,
/// whether the particle approaches or recedes, and the tangential component stays.
///
/// The normal may have any length but 0, and point to either side. Every component is the double nearest to the exact
/// one, for all finite doubles in every floating-point environment; beyond the range it is infinite, and zero is +0.
/// NaN and infinities throw InvalidInput, which names the field and "finite number"; so does a normal of length 0
/// ("nonzero normal"). Contract: reference/response/reflect_plane.h.
Vector3d reflect_plane(const Vector3d& velocity, const Vector3d& normal);

namespace stages {

/// There is no filter: numbers have to be computed. Their degree is 5, too high for the lattice.
struct reflect_plane : Signatures<decltype(robust::reflect_plane)> {
  static Partial enclosed;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
