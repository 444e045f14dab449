// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/volumes.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/broad_phase/all_pairs.h. Right for all finite doubles in every floating-point environment.
///
/// Sort and sweep along the axis on which the solids overlap least: time n log n for the order and then one look at
/// each pair whose intervals meet on that axis. Ends of intervals are compared as integers
/// (robust/kernel/ordered_bits.h); a sphere's are rounded, all of them to nearest, and what is left of the pairs is
/// decided by robust/kernel/spheres.h.
std::vector<IndexPair> all_pairs(const std::vector<Sphere3d>& spheres);
std::vector<IndexPair> all_pairs(const std::vector<Aabb3d>& boxes);

/// The same, and the latest stage that one of the decisions needed. Boxes are compared only: always the first.
std::vector<IndexPair> all_pairs(const std::vector<Sphere3d>& spheres, Stage& decided);
std::vector<IndexPair> all_pairs(const std::vector<Aabb3d>& boxes, Stage& decided);

}  // namespace touchstone::robust
