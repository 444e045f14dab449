// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/batch/isa/columns.h"

namespace touchstone::robust::batch {

/// robust::obb_obb of each two oriented boxes, its Contact: disjoint 0, touching 1, overlapping 2.
void obb_obb(const Obbs3& a, const Obbs3& b, std::size_t count, std::uint8_t* answers, const Limits& limits = {});

}  // namespace touchstone::robust::batch
