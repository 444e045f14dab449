// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// A ball that contains every one of the points exactly, closed: |p - center| <= radius for the doubles returned.
///
/// box, centroid, smallest: each coordinate of the center is that of the method's exact ball, correctly rounded.
/// ritter: the ball grows in doubles. Then the radius is the least double whose ball about that center contains every
/// point, and infinite if there is none. The same bits in every floating-point environment. An empty list throws
/// InvalidInput ("points", "at least 1 point"); so do NaN and infinities ("points[0][1]" ..., "finite number").
/// Smallest takes expected linear time in the number of points. Contract: reference/volumes/bounding_sphere.h.
Sphere3d bounding_sphere(const std::vector<Point3d>& points, SphereMethod method = SphereMethod::smallest);

}  // namespace touchstone::robust
