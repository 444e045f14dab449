// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the sum of the rational cross products of the fan of triangles from the first vertex; degenerate where it is
/// zero. The unit normal is the sum over the root of its squared length. Margin: the greatest coordinate of the sum, in
/// magnitude. Certificate: "no_area", "root" or, where a coordinate of the unit normal is not rational,
/// "irrational_root"; the checker adds up the sum itself.
template <Exact Number = double>
Truth<PolygonNormal<Surd>> polygon_normal(const Polygon3<Number>& polygon);

}  // namespace touchstone::oracle
