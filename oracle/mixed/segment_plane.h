// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rays.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the heights of both ends over the plane are the weights that give the common point. Margin: the squared
/// distance of the nearer end from the plane. Certificate: both heights.
template <Exact Number = double>
Truth<LinePlane<Rational>> segment_plane(const Segment3<Number>& segment, const Plane<Number>& plane);

}  // namespace touchstone::oracle
