// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/batch/isa/columns.h"

namespace touchstone::robust::batch {

/// robust::point_plane_side of each plane and point, its PlaneSide: front 0, on 1, back 2.
void point_plane(const Planes& planes, const Points3& points, std::size_t count, std::uint8_t* answers,
                 const Limits& limits = {});

}  // namespace touchstone::robust::batch
