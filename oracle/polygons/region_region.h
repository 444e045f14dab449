// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: slabs as for polygon_polygon, by the edges of all rings together: on the middle line of a slab a region is
/// between its first crossing and its second, its third and its fourth and so on. Margin: the least squared distance of
/// a vertex of one region from an edge of the other; for `disjoint` that is the squared distance of the two.
/// Certificate: as for polygon_polygon.
template <Exact Number = double>
Truth<Contact> region_region(const Region2<Number>& a, const Region2<Number>& b);

}  // namespace touchstone::oracle
