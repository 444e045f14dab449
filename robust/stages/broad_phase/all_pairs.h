// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/broad_phase/all_pairs.h"
#include "robust/kernel/staged.h"

namespace touchstone::robust::stages {

/// The latest stage that one of its decisions needed. Boxes are compared only: always the first.
struct all_pairs {
  static Decided<std::vector<IndexPair>> ask(const std::vector<Sphere3d>& spheres);
  static Decided<std::vector<IndexPair>> ask(const std::vector<Aabb3d>& boxes);
};

}  // namespace touchstone::robust::stages
