// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: by linear programming, how much the solid has to grow around its center until it holds the point; less than
/// 1: inside, 1: on the boundary, more: outside. On integers.
///
/// Margin: the squared distance of the point from a face's plane: inside, from the nearest; outside, from the farthest
/// of those that it lies beyond (so the solid is no nearer than that).
///
/// Certificate: inside, boundary: "coefficients" of the half axes (`coefficients`, three). outside: "separating_plane"
/// (`normal`).
template <Exact Number = double>
Truth<Location> point_in_obb(const Obb3<Number>& obb, const Point3<Number>& point);

}  // namespace touchstone::oracle
