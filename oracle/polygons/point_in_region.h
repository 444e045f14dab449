// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: `boundary` by definition, every edge of every ring asked. Otherwise the parity of the crossings of a ray with
/// the edges of all rings together (oracle/rings/parity.h). Margin: the least squared distance of the point from an
/// edge. Certificate: as for point_in_polygon, with edges counted through the outer ring and then through each hole.
template <Exact Number = double>
Truth<Location> point_in_region(const Region2<Number>& region, const Point2<Number>& point);

}  // namespace touchstone::oracle
