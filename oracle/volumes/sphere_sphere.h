// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: let d be the distance of the centers and r, s the radii, all of them lengths of segments. The balls have a
/// common point exactly if (r + s)^2 >= d^2, and a common interior point exactly if neither is a point, r + s > r and
/// r + s > s, and r + s > d. So the sign of (r + s)^2 - max(d^2, r^2, s^2) decides; the last two squares are
/// never greater than the first. On integers.
///
/// Margin: the magnitude of that, a difference of squared lengths. The balls are disjoint where it is negative,
/// overlapping where it is positive, touching where it is 0.
///
/// Certificate: disjoint: "distance" (`squared_distance` of the centers). overlapping: "common_interior_point"
/// (`point`). touching: a common `point`, and why there is no interior one: "tangent" (no ball reaches beyond it) or
/// "no_interior" (a radius is 0).
template <Exact Number = double>
Truth<Contact> sphere_sphere(const Circle2<Number>& a, const Circle2<Number>& b);
template <Exact Number = double>
Truth<Contact> sphere_sphere(const Sphere3<Number>& a, const Sphere3<Number>& b);

}  // namespace touchstone::oracle
