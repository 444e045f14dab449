// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polygons.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The indices of the extreme points in the plane: counter-clockwise, from the lexicographically least; of equal points
/// the first. One if all are equal, two if all are collinear. Requires at least one point, all finite, and IEEE
/// arithmetic (kernel/control_word.h). `latest` becomes the later one of its value and the last stage that any decision
/// needed.
std::vector<Index> planar_hull(const std::vector<Point2d>& points, Stage& latest);

}  // namespace touchstone::robust
