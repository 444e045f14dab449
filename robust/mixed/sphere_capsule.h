// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a ball and a capsule, as closed solids, are `disjoint`, only touch or overlap. A capsule is the set
/// of points no farther than its radius from its segment.
///
/// `touching`: they have a common point and no common interior point: one only reaches the other, or a radius is 0. A
/// segment of length 0 is a point. Right for all finite doubles in every floating-point environment. NaN and infinities
/// throw InvalidInput, which names the field and "finite number"; so does a negative radius ("radius >= 0"). Contract:
/// reference/mixed/sphere_capsule.h.
Contact sphere_capsule(const Sphere3d& sphere, const Capsule3d& capsule);

namespace stages {

/// The filter first decides balls that are beyond the box around the ends of the segment.
struct sphere_capsule : Signatures<decltype(robust::sphere_capsule)> {
  static Partial filter, enclosed;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
