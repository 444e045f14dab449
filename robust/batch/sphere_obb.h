// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/batch/isa/columns.h"

namespace touchstone::robust::batch {

/// robust::sphere_obb of each sphere and oriented box, its Contact: disjoint 0, touching 1, overlapping 2.
void sphere_obb(const Spheres3& spheres, const Obbs3& boxes, std::size_t count, std::uint8_t* answers,
                const Limits& limits = {});

}  // namespace touchstone::robust::batch
