// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// Answers and refuses as `all_pairs` does: balls by a hierarchy of spheres (robust/structures/ball_tree.h), boxes by
/// one of boxes (robust/structures/box_tree.h). Right for all finite doubles in every floating-point environment; NaN
/// and infinities throw InvalidInput.
std::vector<IndexPair> sphere_hierarchy(const std::vector<Sphere3d>& spheres);
std::vector<IndexPair> sphere_hierarchy(const std::vector<Aabb3d>& boxes);

}  // namespace touchstone::robust
