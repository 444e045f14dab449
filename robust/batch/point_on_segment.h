// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/batch/isa/columns.h"

namespace touchstone::robust::batch {

/// robust::point_on_segment_relation of each point and segment, its Incidence: on 0, off 1.
void point_on_segment(const Points2& points, const Segments2& segments, std::size_t count, std::uint8_t* answers,
                      const Limits& limits = {});

}  // namespace touchstone::robust::batch
