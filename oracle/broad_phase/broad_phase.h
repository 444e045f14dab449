// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/commands.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: to each query, of the boxes that are there at that moment, all pairs as all_pairs has them, or those of a
/// tree of boxes that a query meets (oracle/exact/shapes/queries_of_boxes.h), a ray by the dual of a linear program.
/// Margin: the least of all queries, a squared length; for pairs, the margin of all_pairs. Where no query of pairs sees
/// two bodies, and no other query sees one, there is no margin. Certificate: a proof for each reply. For at most 16
/// bodies, one for each of them; for more, along a tree that follows `replies`.
template <Exact Number = double>
Truth<Replies> broad_phase(const std::vector<Aabb3<Number>>& boxes, const std::vector<Command<Number>>& commands);

}  // namespace touchstone::oracle
