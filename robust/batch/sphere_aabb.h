// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/batch/isa/columns.h"

namespace touchstone::robust::batch {

/// robust::sphere_aabb of each sphere and box, in the plane or in space, its Contact: disjoint 0, touching 1,
/// overlapping 2.
void sphere_aabb(const Spheres2& spheres, const Boxes2& boxes, std::size_t count, std::uint8_t* answers,
                 const Limits& limits = {});
void sphere_aabb(const Spheres3& spheres, const Boxes3& boxes, std::size_t count, std::uint8_t* answers,
                 const Limits& limits = {});

}  // namespace touchstone::robust::batch
