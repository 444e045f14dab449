// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/triangles.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the point of the triangle that is nearest to the center, by the conditions of Karush, Kuhn and Tucker in
/// rationals (oracle/exact/shapes/nearest_pair.h); its squared distance against that of the radius.
///
/// Margin: |S - r^2|, S being the squared distance: 0 for a tangent ball, and for a point in the triangle.
///
/// Certificate: disjoint: "nearest_points" (`weights` of the corners, which give the nearest point; it is farther than
/// the radius). touching: "tangent" (as far as the radius) or "no_interior" (the radius is 0). overlapping:
/// "near_points" (nearer than the radius).
template <Exact Number = double>
Truth<Contact> sphere_triangle(const Sphere3<Number>& sphere, const Triangle3<Number>& triangle);

}  // namespace touchstone::oracle
