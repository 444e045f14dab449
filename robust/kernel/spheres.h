// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>

#include "robust/kernel/sphere_filter.h"
#include "robust/kernel/stage.h"

/// Whether two balls meet: exactly, in every floating-point environment. Finite numbers, radii not negative.
namespace touchstone::robust::kernel {

/// The stages of `reach`.
std::optional<int> reach_lattice(const Sphere3d& a, const Sphere3d& b);
int reach_exact(const Sphere3d& a, const Sphere3d& b);
int reach_past_filter(const Sphere3d& a, const Sphere3d& b, Stage& decided);

/// The sign of the radii's sum minus the distance of the centres. -1: the balls have no common point. 0: they have one,
/// on the boundary of both. 1: they have a common interior point if both have an interior, that is, no radius is 0.
/// `latest` becomes the stage that decided, if that is later.
inline int reach(const Sphere3d& a, const Sphere3d& b, Stage& latest) {
  const filters::Sign sign = filters::spheres(a, b);
  if (sign != filters::Sign::unknown) return sign == filters::Sign::positive ? 1 : -1;
  Stage decided;
  const int found = reach_past_filter(a, b, decided);
  latest = std::max(latest, decided);
  return found;
}

}  // namespace touchstone::robust::kernel
