// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the point of the box that is nearest to the center, by the conditions of Karush, Kuhn and Tucker in rationals
/// (oracle/exact/shapes/nearest_pair.h); its squared distance against that of the radius. A box has an interior, and
/// points of that are as near to each of its points as one likes.
///
/// Margin: |S - r^2|, S being the squared distance: 0 for a tangent ball, and for a point in the box.
///
/// Certificate: disjoint: "nearest_points" (`coefficients` of the half axes, which give the nearest point; it is
/// farther than the radius). touching: "tangent" (as far as the radius). overlapping: "near_points" (nearer than the
/// radius).
template <Exact Number = double>
Truth<Contact> sphere_obb(const Sphere3<Number>& sphere, const Obb3<Number>& obb);

}  // namespace touchstone::oracle
