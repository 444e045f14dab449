// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a ball and the half-space normal . p + offset <= 0, the plane and its back, as closed solids, are
/// `disjoint`, only touch or overlap.
///
/// `touching`: they have a common point and no common interior point: the ball only reaches the plane from in front; or
/// the radius is 0 and the center in the half-space, however deep. A ball within the half-space overlaps it. Right for
/// all finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names the field
/// and "finite number"; so do a negative radius ("radius >= 0") and a normal of length 0 ("nonzero normal"). Contract:
/// reference/mixed/sphere_plane.h.
Contact sphere_plane(const Sphere3d& sphere, const Plane3d& plane);

namespace stages {

/// The filter decides centers whose distance from the plane clearly differs from the radius, in front or behind. There
/// is no lattice: squares of heights exceed it.
struct sphere_plane : Signatures<decltype(robust::sphere_plane)> {
  static Partial filter;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
