// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/volumes.h"
#include "robust/kernel/filters/strict_math.h"

/// All pairs of boxes that meet, by a binary tree over the boxes.
namespace touchstone::robust::structures {

/// Evidence that a list of pairs is complete; oracle/certificates/README.md explains each part.
struct PairProof {
  std::vector<Index> order;  ///< the boxes in tree order
  std::vector<Index> cuts;   ///< for each node in preorder: the count of boxes of its first child, 0 = leaf
  std::vector<std::uint8_t>
      steps;  ///< 2 bits a step: two nodes are apart, one of them is opened, or leaves are compared
};

/// The pairs i < j of valid boxes that meet, sorted; and the proof, if requested. Right for all finite doubles in every
/// floating-point environment. The tree affects only the time: n log n plus the pairs if boxes are of similar size or
/// of many sizes; about n^1.5 for long boxes across each other.
std::vector<IndexPair> tree_pairs(const std::vector<Aabb3d>& boxes, PairProof* proof = nullptr);

/// The same pairs in any order, which costs less.
std::vector<IndexPair> unsorted_tree_pairs(const std::vector<Aabb3d>& boxes);

}  // namespace touchstone::robust::structures
