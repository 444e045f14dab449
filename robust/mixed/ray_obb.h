// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "robust/kernel/solids/obb_passage.h"

namespace touchstone::robust {

/// Finds where a ray enters and leaves an oriented box: `hit` with the first and the last t, in units of the
/// direction's length; or `none`.
///
/// Touching is a hit, grazing along a face too. first is 0 if the origin is in the box. The half axes need not be
/// perpendicular: the box is the parallelepiped that they span, exactly. Right for all finite doubles in every
/// floating-point environment, and both numbers correctly rounded. NaN and infinities throw InvalidInput, which names
/// the field and "finite number"; so do a direction of length 0 ("nonzero direction") and half axes that are linearly
/// dependent ("obb.half_axes", "linearly independent"). Contract: reference/mixed/ray_obb.h.
Passage<double> ray_obb(const Ray3d& ray, const Obb3d& obb);

namespace stages {

struct ray_obb : kernel::ObbPassage {
  static Decided<Passage<double>> ask(const kernel::Line& ray, const Obb3d& obb);
};

}  // namespace stages

}  // namespace touchstone::robust
