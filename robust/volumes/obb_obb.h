// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether two oriented boxes, as closed solids, are `disjoint`, only touch or overlap.
///
/// The half axes need not be perpendicular: the boxes are the parallelepipeds that they span, exactly. Right for all
/// finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names the field and
/// "finite number"; so do half axes that are linearly dependent ("a.half_axes", "linearly independent"). Contract:
/// reference/volumes/obb_obb.h.
Contact obb_obb(const Obb3d& a, const Obb3d& b);

namespace stages {

struct obb_obb : Signatures<decltype(robust::obb_obb)> {
  static Partial filter, lattice;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
