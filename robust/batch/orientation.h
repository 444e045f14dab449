// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/batch/isa/columns.h"

namespace touchstone::robust::batch {

/// robust::orientation of each p0, p1, p, its Side: left 0, on 1, right 2.
void orientation(const Points2& p0, const Points2& p1, const Points2& p, std::size_t count, std::uint8_t* answers,
                 const Limits& limits = {});

}  // namespace touchstone::robust::batch
