// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polygons.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The extreme points of points in the plane, by their places: counter-clockwise, from the lexicographically least on;
/// of equal points the first. One if all are equal, two if all lie on one line. The points are finite, there is at
/// least one, and arithmetic is IEEE's (kernel/control_word.h). `latest` becomes the later one of what it was and the
/// last stage that any decision needed.
std::vector<Index> planar_hull(const std::vector<Point2d>& points, Stage& latest);

}  // namespace touchstone::robust
