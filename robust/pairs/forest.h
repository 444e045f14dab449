// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "geometry/volumes.h"
#include "robust/batch/isa/limits.h"

namespace touchstone::robust::pairs {

/// The pairs i < j of valid boxes that meet, sorted. Right for all finite doubles in every floating-point environment,
/// with every instruction set: `at_most` leaves out wider ones; the same on any number of threads. Time: n log n plus
/// the pairs, for boxes of similar size, of many sizes, and long ones across each other.
///
/// Boxes of like size are put in the order of a curve that fills space, and eight neighbours make a leaf of a tree,
/// whose nodes are compared eight at a time by integers of 32 bits (robust/batch/isa/eight_boxes.h).
std::vector<IndexPair> forest_pairs(const std::vector<Aabb3d>& boxes, std::size_t threads = 1,
                                    batch::Instructions at_most = batch::Instructions::avx512);

class Forest;

/// The same pairs for a list that is queried repeatedly while its boxes move: the order is kept, and made anew now and
/// then.
class KeptForest {
 public:
  KeptForest();
  KeptForest(KeptForest&&) noexcept;
  KeptForest& operator=(KeptForest&&) noexcept;
  ~KeptForest();

  /// The result of forest_pairs(boxes), valid until the next call.
  const std::vector<IndexPair>& pairs(const std::vector<Aabb3d>& boxes);

 private:
  std::unique_ptr<Forest> forest_;
  unsigned refits_ = 0;  ///< since the order was made
  std::vector<IndexPair> pairs_;
};

}  // namespace touchstone::robust::pairs
