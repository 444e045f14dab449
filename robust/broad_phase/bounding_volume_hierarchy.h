// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/commands.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// Answers and refuses as `broad_phase` does, by a balanced tree of boxes (robust/structures/box_tree.h). Right for all
/// finite doubles in every floating-point environment; NaN and infinities throw InvalidInput.
Replies bounding_volume_hierarchy(const std::vector<Aabb3d>& boxes, const std::vector<Commandd>& commands);

}  // namespace touchstone::robust
