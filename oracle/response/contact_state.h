// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bodies.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the motion of a as b sees it, written as the velocity of the origin and a turn around it, against the normal
/// as a line through the contact, written by its direction n and its moment p x n: n . velocity + (p x n) . turn, a
/// sign over rationals.
///
/// Margin: the squared relative velocity along the normal, per length of the normal.
///
/// Certificate: "point_velocities": of the bodies at the contact, `of_a` and `of_b`.
template <Exact Number = double>
Truth<ContactState> contact_state(const MovingBody<Number>& a, const MovingBody<Number>& b, const Point3<Number>& point,
                                  const Vector3<Number>& normal);

}  // namespace touchstone::oracle
