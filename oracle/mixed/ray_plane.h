// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rays.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the heights over the plane of the origin and of origin + direction are the weights that give the common
/// point. Margin: the lesser of the squared distance of the origin from the plane and the square of how far origin +
/// direction is from the parallel plane through the origin: what has to change until the ray leads along the plane.
/// Certificate: both heights.
template <Exact Number = double>
Truth<LinePlane<Rational>> ray_plane(const Ray3<Number>& ray, const Plane<Number>& plane);

}  // namespace touchstone::oracle
