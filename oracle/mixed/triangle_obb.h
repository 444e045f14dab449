// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/triangles.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: by linear programming over the weights of the triangle's corners and the coefficients of the half axes, how
/// much the box has to grow around its center, by a factor, until it has a point of the triangle; less than 1: they
/// overlap, 1: they touch, more: they are disjoint. On integers.
///
/// Margin: a squared length: how far the nearest face moves in that growth. Whatever moves by less than that leaves the
/// answer as it is.
///
/// Certificate: as that of obb_obb, with `on_a`, weights of the corners, and `on_b`, coefficients; `normal` leads from
/// the triangle to the box.
template <Exact Number = double>
Truth<Contact> triangle_obb(const Triangle3<Number>& triangle, const Obb3<Number>& obb);

}  // namespace touchstone::oracle
