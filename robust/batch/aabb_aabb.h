// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/batch/isa/columns.h"

namespace touchstone::robust::batch {

/// robust::aabb_aabb of each a and b, in the plane or in space, its Contact: disjoint 0, touching 1, overlapping 2.
void aabb_aabb(const Boxes2& a, const Boxes2& b, std::size_t count, std::uint8_t* answers, const Limits& limits = {});
void aabb_aabb(const Boxes3& a, const Boxes3& b, std::size_t count, std::uint8_t* answers, const Limits& limits = {});

}  // namespace touchstone::robust::batch
