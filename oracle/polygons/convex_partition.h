// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "oracle/rings/triangulation.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: one partition of many: triangles from cutting diagonal by diagonal, each merged into the first piece that
/// stays convex. Margin: the least size of twice the area of three consecutive vertices, which is 0 if one is flat: how
/// far the vertices are from changing between convex and reflex.
template <Exact Number = double>
Truth<IndexLists> convex_partition(const Polygon2<Number>& polygon);

/// The defect of a partition of a simple polygon into convex pieces; "" if it is right, ours or not.
std::string convex_partition_defect(const Polygon2d& polygon, const IndexLists& pieces);

}  // namespace touchstone::oracle
