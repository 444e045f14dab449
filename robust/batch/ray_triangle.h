// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/batch/isa/columns.h"

namespace touchstone::robust::batch {

/// robust::ray_triangle_relation of each ray and triangle, its SegmentTriangleRelation: none 0, point 1, segment 2.
void ray_triangle(const Rays3& rays, const Triangles3& triangles, std::size_t count, std::uint8_t* answers,
                  const Limits& limits = {});

}  // namespace touchstone::robust::batch
