// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/commands.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/strict_math.h"

namespace touchstone::robust {

/// Which bodies meet while some come, move and go: to each query, in order, the pairs of bodies i < j that are there
/// and meet, sorted. Boxes that only touch meet.
///
/// Right for all finite doubles in every floating-point environment. Each query is a sort and sweep
/// (robust/structures/swept_boxes.h). NaN and infinities throw InvalidInput, which names the field and "finite number";
/// so do min > max ("min <= max") and a body that is not there ("index of a body that is there"). Contract:
/// reference/broad_phase/broad_phase.h.
Replies broad_phase(const std::vector<Aabb3d>& boxes, const std::vector<Commandd>& commands);

}  // namespace touchstone::robust
