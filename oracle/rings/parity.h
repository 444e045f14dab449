// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/answers.h"
#include "oracle/exact/numbers/decode.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// The location of the origin among all edges of closed rings, even-odd, in integers of one unit: `boundary` by
/// definition, every edge asked. Otherwise the parity of the crossings of a ray in a direction that is parallel to no
/// line through the origin and a vertex; two such rays have to agree. Margin: the least squared distance of the origin
/// from an edge.
///
/// Certificate: boundary: "on_edge" (`edge`, counted through all rings, and `t`). Else "crossings" (`direction`, the
/// `edges` that the ray crosses, and where, `t`).
Truth<Location> location_by_parity(const std::vector<Polygon2<Integer>>& rings, const Rational& unit);

}  // namespace touchstone::oracle
