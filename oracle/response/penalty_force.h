// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/space.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: where the sign of the rational E = N . p + d is negative, the stiffness times the displacement to the foot of
/// the point on the plane, less the damping times what the velocity has beyond its part across the normal. Foot and
/// part are put together from their products with three vectors at right angles, the normal among them.
///
/// Margin: E^2 / (N . N), the squared distance from the plane, on which the force begins.
///
/// Certificate: E < 0: "foot": the `foot` of the point on the plane, and what the velocity has `along` the normal.
/// Otherwise "no_contact".
template <Exact Number = double>
Truth<Vector3<Rational>> penalty_force(const Point3<Number>& point, const Vector3<Number>& velocity,
                                       const Plane<Number>& plane, const Number& stiffness, const Number& damping);

}  // namespace touchstone::oracle
