// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: each pair on its own, on integers, but those that are farther apart on an axis than another pair is from its
/// other answer: they do not meet, and theirs is not the least margin. Spheres meet if the squared distance of their
/// centres is not greater than the squared sum of the radii; boxes if on each axis neither begins beyond the other's
/// end.
/// Margin: the least over all pairs, a squared length. For spheres, the difference of these two squares; for boxes, the
/// square of the distance by which one must be moved for them to separate or to touch along the axes: the longest if
/// they are apart and the shortest if they meet. Fewer than two solids have no other answer however they change: there
/// is no margin. Time: of n solids n log n, and the pairs that are near each other on the axis where these are fewest;
/// n^2 at worst.
template <Exact Number = double>
Truth<std::vector<IndexPair>> all_pairs(const std::vector<Sphere3<Number>>& spheres);
template <Exact Number = double>
Truth<std::vector<IndexPair>> all_pairs(const std::vector<Aabb3<Number>>& boxes);

}  // namespace touchstone::oracle
