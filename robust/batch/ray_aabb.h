// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/batch/isa/columns.h"

namespace touchstone::robust::batch {

/// robust::ray_aabb_relation of each ray and box, in the plane or in space, its PassageRelation: none 0, hit 1.
void ray_aabb(const Rays2& rays, const Boxes2& boxes, std::size_t count, std::uint8_t* answers,
              const Limits& limits = {});
void ray_aabb(const Rays3& rays, const Boxes3& boxes, std::size_t count, std::uint8_t* answers,
              const Limits& limits = {});

}  // namespace touchstone::robust::batch
