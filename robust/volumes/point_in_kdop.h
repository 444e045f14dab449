// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a point lies inside a k-DOP, the solid of all P with d1 <= N . P <= d2 for the normal N of every
/// slab [d1, d2], on its `boundary` or outside.
///
/// boundary: no slab excludes the point, and one of them ends at it; so a flat slab has no inside. Normals have any
/// length but 0. Right for all finite doubles in every floating-point environment. NaN and infinities throw
/// InvalidInput, which names the field and "finite number"; so do a normal of length 0 ("nonzero normal"), d1 > d2
/// ("min <= max"), a list without normals and lists of different lengths. Contract: reference/volumes/point_in_kdop.h.
Location point_in_kdop(const Kdop3d& kdop, const Point3d& point);

namespace stages {

/// Each stage takes all slabs together; a slab that excludes the point decides alone.
struct point_in_kdop : Signatures<decltype(robust::point_in_kdop)> {
  static Partial filter, lattice;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
