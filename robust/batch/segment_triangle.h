// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/batch/isa/columns.h"

namespace touchstone::robust::batch {

/// robust::segment_triangle_relation of each segment and triangle, its SegmentTriangleRelation: none 0, point 1,
/// segment 2.
void segment_triangle(const Segments3& segments, const Triangles3& triangles, std::size_t count, std::uint8_t* answers,
                      const Limits& limits = {});

}  // namespace touchstone::robust::batch
