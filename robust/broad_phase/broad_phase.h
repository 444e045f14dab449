// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/commands.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// Finds which bodies meet each other, a box, a point or a ray while bodies are added, moved and removed: a reply to
/// each query, in order. Pairs are i < j, sorted; bodies are sorted by index, or along a ray in the order in which it
/// meets them. Boxes that only touch meet.
///
/// Right for all finite doubles in every floating-point environment. `pairs` is a sort and sweep; the other queries
/// test each body (robust/structures/swept_boxes.h). NaN and infinities throw InvalidInput, which names the field and
/// "finite number"; so do min > max ("min <= max"), a ray without a direction ("nonzero direction") and a missing body
/// ("index of a body that is there"). Contract: reference/broad_phase/broad_phase.h.
Replies broad_phase(const std::vector<Aabb3d>& boxes, const std::vector<Commandd>& commands);

}  // namespace touchstone::robust
