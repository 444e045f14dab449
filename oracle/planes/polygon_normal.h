// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the sum of the rational cross products of the fan of triangles from the first vertex; degenerate where it is
/// zero. Each coordinate of the unit normal is the root of its square over the squared length, by exact comparison of
/// squares: rational where that is a square, otherwise a rational that has the same nearest double (and sign) and is
/// within 2^-60 units in the last place. Margin: the greatest coordinate of the sum, in magnitude.
Truth<PolygonNormal<Rational>> polygon_normal(const Polygon3d& polygon);
template <Exact Number>
Truth<PolygonNormal<Rational>> polygon_normal(const Polygon3<Number>& polygon);

}  // namespace touchstone::oracle
