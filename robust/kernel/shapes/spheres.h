// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/filters/sphere_filter.h"
#include "robust/kernel/filters/staged.h"

/// Decides whether two balls meet: exactly, in every floating-point environment. Finite numbers, radii not negative.
namespace touchstone::robust::kernel {

/// The sign of the radii's sum minus the distance of the centers. -1: the balls have no common point. 0: they have one,
/// on the boundary of both. 1: they have a common interior point if both have an interior, that is, no radius is 0.
struct Reach : Filtered<Reach, int(const Sphere3d&, const Sphere3d&)> {
  static Perhaps<int> filter(const Sphere3d& a, const Sphere3d& b) {
    return filters::by_sign(filters::spheres(a, b), 1, -1);
  }
  static Partial lattice;
  static Total exact;
  static Staged past_filter;
};

}  // namespace touchstone::robust::kernel
