// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: on homogeneous integers. The point is (X, Y, Z, W), W > 0; the planes of a slab are (a, b, c, -d1) and
/// (a, b, c, -d2), on one scale. The depth in the slab is the lesser of a X + b Y + c Z - d1 W and d2 W - (a X + b Y +
/// c Z); times its size, over a^2 + b^2 + c^2, it is a squared distance with the depth's sign. The least of these over
/// all slabs decides: outside where it is negative, on the boundary where it is 0, inside where it is positive.
/// Margin: its magnitude.
///
/// Certificate: outside: "beyond_slab", boundary: "end_of_slab"; both with the place of the `slab` that decides and the
/// `value` N . P there. inside: "values", N . P of all slabs.
template <Exact Number = double>
Truth<Location> point_in_kdop(const Kdop3<Number>& kdop, const Point3<Number>& point);

}  // namespace touchstone::oracle
