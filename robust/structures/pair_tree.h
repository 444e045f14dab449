// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/volumes.h"
#include "robust/kernel/filters/strict_math.h"

/// All pairs of boxes that meet, by a binary tree over the boxes.
namespace touchstone::robust::structures {

/// Shows that a list of pairs is complete; oracle/certificates/README.md explains each part.
struct PairProof {
  std::vector<Index> order;  ///< the boxes in the order of the tree
  std::vector<Index> cuts;   ///< of each node in preorder: how many boxes its first child has; 0: a leaf
  std::vector<std::uint8_t>
      steps;  ///< 2 bits a step: two nodes are apart, one of them is opened, or leaves are compared
};

/// The pairs i < j of valid boxes that meet, sorted; and the proof, if one is wanted. Right for all finite doubles in
/// every floating-point environment. The tree decides only how long it takes: n log n and the pairs where boxes are of
/// like size or of many sizes; about n^1.5 for long boxes across each other.
std::vector<IndexPair> tree_pairs(const std::vector<Aabb3d>& boxes, PairProof* proof = nullptr);

class PairTree;

/// The same pairs of a list that is asked again and again while its boxes move: the tree is kept, with all memory, and
/// fitted to where the boxes are now; it is made anew when it has become bad.
class KeptPairTree {
 public:
  KeptPairTree();
  KeptPairTree(KeptPairTree&&) noexcept;
  KeptPairTree& operator=(KeptPairTree&&) noexcept;
  ~KeptPairTree();

  /// What tree_pairs(boxes) is, until the next call.
  const std::vector<IndexPair>& pairs(const std::vector<Aabb3d>& boxes);

 private:
  std::unique_ptr<PairTree> tree_;
  std::size_t at_first_ = 0;  ///< comparisons when it was made
  std::vector<IndexPair> pairs_;
};

}  // namespace touchstone::robust::structures
