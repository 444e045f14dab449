// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/batch/isa/columns.h"

namespace touchstone::robust::batch {

/// robust::triangle_triangle of each a and b, its TriangleTriangleRelation: none 0, point 1, segment 2, area 3.
void triangle_triangle(const Triangles3& a, const Triangles3& b, std::size_t count, std::uint8_t* answers,
                       const Limits& limits = {});

}  // namespace touchstone::robust::batch
