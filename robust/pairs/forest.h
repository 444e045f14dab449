// SPDX-License-Identifier: Apache-2.0
#pragma once

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

}  // namespace touchstone::robust::pairs
