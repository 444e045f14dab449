// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "geometry/volumes.h"

namespace touchstone::simulate {

/// Pairs i < j of boxes that meet, in order, by sort and sweep along x: the broad phase of p. 55.
std::vector<std::pair<std::size_t, std::size_t>> near_pairs(const std::vector<Aabb3d>& boxes);

}  // namespace touchstone::simulate
