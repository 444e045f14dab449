// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Finds which of several balls, or of several boxes, meet: the pairs of indices i < j in the list, sorted. Solids that
/// only touch meet; a ball of radius 0 and a box with min == max are points.
///
/// Right for all finite doubles in every floating-point environment. Balls: sort and sweep along the axis on which they
/// overlap least, in time n log n for the order and then one test of each pair whose intervals meet on that axis.
/// Boxes: trees made for the list (robust/pairs/forest.h), in time n log n and the number of pairs. At most
/// 2^32 - 1 solids. `threads` is the number of threads that may be used, 0 for as many as the machine runs at once: the
/// answer is the same. NaN and infinities throw InvalidInput, which names the field and "finite number"; so do a
/// negative radius ("radius >= 0") and min > max ("min <= max"). Contract: reference/broad_phase/all_pairs.h.
std::vector<IndexPair> all_pairs(const std::vector<Sphere3d>& spheres);
std::vector<IndexPair> all_pairs(const std::vector<Aabb3d>& boxes);
std::vector<IndexPair> all_pairs(const std::vector<Aabb3d>& boxes, std::size_t threads);

/// The pairs of boxes, and evidence that none is missing: a tree over the boxes, and the search of it. `certify` and
/// certify.py check it; oracle/certificates/README.md defines the format. By another tree than all_pairs, for which
/// long boxes across each other take about n^1.5 (robust/structures/pair_tree.h).
struct PairsWithCertificate {
  std::vector<IndexPair> pairs;     ///< as in all_pairs
  std::vector<Index> order;         ///< the boxes in tree order
  std::vector<Index> cuts;          ///< for each node in preorder: the count of boxes of its first child, 0 = leaf
  std::vector<std::uint8_t> steps;  ///< 2 bits a step, the lowest first
};
PairsWithCertificate pairs_with_certificate(const std::vector<Aabb3d>& boxes);

namespace stages {

/// The latest stage that one of its decisions needed. Boxes are only compared: always the first.
struct all_pairs {
  static Decided<std::vector<IndexPair>> ask(const std::vector<Sphere3d>& spheres);
  static Decided<std::vector<IndexPair>> ask(const std::vector<Aabb3d>& boxes, std::size_t threads = 1);
};

}  // namespace stages

}  // namespace touchstone::robust
