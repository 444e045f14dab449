// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// The interior angle at every vertex of a simple polygon, in radians, in the order of the vertices: pi at a flat
/// vertex, more at a reflex one.
///
/// The polygon may run in either direction. Every angle correctly rounded for all finite doubles, in every
/// floating-point environment: exact products, and an arc tangent on integers until both of its bounds round to the
/// same double. NaN and infinities throw InvalidInput, which names the field and "finite number"; so do fewer than 3
/// vertices and a polygon that is not simple (with the vertex). Contract: reference/polygons/interior_angles.h.
std::vector<double> interior_angles(const Polygon2d& polygon);

}  // namespace touchstone::robust
