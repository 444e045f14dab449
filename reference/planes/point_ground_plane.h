// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"

namespace touchstone::reference {

/// Decides whether a point of space lies above, on or below the ground, the plane y = 0 (y is up).
///
/// Deck p. 20: the sign of y; above where y > 0, below where y < 0, on where y = 0. point: any unit of length. The
/// ground is a closed set: `on` means exactly y = 0, and -0.0 is 0. x and z play no part in the answer, but have to be
/// numbers. NaN or infinity in any coordinate: refused by robust and oracle (field, "finite number").
///
/// Rounding: none; two comparisons with 0 are exact, so the double version is right for every input whose environment
/// does not read subnormals as zero. The margin is |y|; nothing is computed that could spoil it. No number is returned.
template <class Real>
Height point_ground_plane(const Point3<Real>& point) {
  return point.y > Real(0) ? Height::above : point.y < Real(0) ? Height::below : Height::on;
}

}  // namespace touchstone::reference
