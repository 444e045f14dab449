// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "robust/kernel/solids/obb_passage.h"

namespace touchstone::robust {

/// Finds where a closed segment enters and leaves an oriented box: `hit` with the first and the last t, 0 at a and 1 at
/// b; or `none`.
///
/// Touching is a hit, grazing along a face too. first is 0 if a is in the box, last is 1 if b is; a segment of length 0
/// is a point, both are 0. The half axes need not be perpendicular: the box is the parallelepiped that they span,
/// exactly. Right for all finite doubles in every floating-point environment, and both numbers correctly rounded. NaN
/// and infinities throw InvalidInput, which names the field and "finite number"; so do half axes that are linearly
/// dependent ("obb.half_axes", "linearly independent"). Contract: reference/mixed/segment_obb.h.
Passage<double> segment_obb(const Segment3d& segment, const Obb3d& obb);

namespace stages {

struct segment_obb : kernel::ObbPassage {
  static Decided<Passage<double>> ask(const kernel::Line& segment, const Obb3d& obb);
};

}  // namespace stages

}  // namespace touchstone::robust
