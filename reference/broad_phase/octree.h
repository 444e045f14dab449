// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "reference/broad_phase/quadtree.h"

namespace touchstone::reference {

template <class Real>
using Octree = CellTree<Real, true>;

/// Answers `broad_phase` by an octree.
///
/// Deck p. 62: a cell with many bodies is cut into eight. Input, answer and refusals:
/// reference/broad_phase/broad_phase.h. It is right under the conditions of reference/broad_phase/quadtree.h.
template <class Real>
Replies octree(const std::vector<Aabb3<Real>>& boxes, const std::vector<Command<Real>>& commands) {
  return replies(InStructure<Octree, Real>{}, boxes, commands);
}

}  // namespace touchstone::reference
