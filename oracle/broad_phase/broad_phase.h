// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/commands.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: to each query, all pairs of the boxes that are there at that moment, as all_pairs has them.
/// Margin: the least of all queries, a squared length; that of a query is the margin of all_pairs.
/// Where no query sees two bodies there is no margin.
Truth<Replies> broad_phase(const std::vector<Aabb3d>& boxes, const std::vector<Command<double>>& commands);
template <Exact Number>
Truth<Replies> broad_phase(const std::vector<Aabb3<Number>>& boxes, const std::vector<Command<Number>>& commands);

}  // namespace touchstone::oracle
