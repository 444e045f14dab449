// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/batch/isa/columns.h"

namespace touchstone::robust::batch {

/// robust::capsule_capsule of each two capsules, its Contact: disjoint 0, touching 1, overlapping 2.
void capsule_capsule(const Capsules3& a, const Capsules3& b, std::size_t count, std::uint8_t* answers,
                     const Limits& limits = {});

}  // namespace touchstone::robust::batch
