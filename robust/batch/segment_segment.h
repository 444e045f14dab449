// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/batch/isa/columns.h"

namespace touchstone::robust::batch {

/// robust::segment_segment_relation of each a and b, its SegmentRelation: disjoint 0, point 1, overlap 2.
void segment_segment(const Segments2& a, const Segments2& b, std::size_t count, std::uint8_t* answers,
                     const Limits& limits = {});

}  // namespace touchstone::robust::batch
