// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/staged.h"

namespace touchstone::robust {

/// Which of several balls, or of several boxes, meet: the pairs of places i < j in the list, sorted. Solids that only
/// touch meet; a ball of radius 0 and a box with min == max are points.
///
/// Right for all finite doubles in every floating-point environment. Sort and sweep along the axis on which the solids
/// overlap least: time n log n for the order and then one look at each pair whose intervals meet on that axis. NaN and
/// infinities throw InvalidInput, which names the field and "finite number"; so do a negative radius ("radius >= 0")
/// and min > max ("min <= max"). Contract: reference/broad_phase/all_pairs.h.
std::vector<IndexPair> all_pairs(const std::vector<Sphere3d>& spheres);
std::vector<IndexPair> all_pairs(const std::vector<Aabb3d>& boxes);

/// Each stage alone, for tests and other operations; no promise to users.
namespace stages {

/// The latest stage that one of its decisions needed. Boxes are compared only: always the first.
struct all_pairs {
  static Decided<std::vector<IndexPair>> ask(const std::vector<Sphere3d>& spheres);
  static Decided<std::vector<IndexPair>> ask(const std::vector<Aabb3d>& boxes);
};

}  // namespace stages

}  // namespace touchstone::robust
