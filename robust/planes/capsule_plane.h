// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a capsule and the half-space normal . p + offset <= 0, the plane and its back, as closed solids, are
/// `disjoint`, only touch or overlap. A capsule is the set of points no farther than its radius from its segment.
///
/// `touching`: they have a common point and no common interior point: the capsule only reaches the plane from in front;
/// or the radius is 0 and some of the segment in the half-space, however deep. A capsule within the half-space overlaps
/// it. A segment of length 0 is a point. Right for all finite doubles in every floating-point environment. NaN and
/// infinities throw InvalidInput, which names the field and "finite number"; so do a negative radius ("radius >= 0")
/// and a normal of length 0 ("nonzero normal"). Contract: reference/planes/capsule_plane.h.
Contact capsule_plane(const Capsule3d& capsule, const Plane3d& plane);

namespace stages {

/// The stages of sphere_plane for both ends.
struct capsule_plane : Signatures<decltype(robust::capsule_plane)> {
  static Partial filter;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
