// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether two k-DOPs with the same normals are `disjoint`, only touch or overlap, slab by slab: conservative,
/// because slabs may meet where the solids do not. A flat slab (min == max) has no interior: it can only touch.
///
/// Right for all finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names
/// the field and "finite number"; so does every k-DOP that point_in_kdop refuses, and so do normals of b that are not
/// those of a ("the same normals as a", "the same normal as in a"). Contract: reference/volumes/kdop_kdop.h.
Contact kdop_kdop(const Kdop3d& a, const Kdop3d& b);

namespace stages {

/// The filter uses differences of all slabs, the exact stage compares the bits as integers; there is no lattice.
struct kdop_kdop : Signatures<decltype(robust::kdop_kdop)> {
  static Partial filter;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
