// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/validation.h"
#include "oracle/rings/whole.h"

namespace touchstone::oracle {

/// The first defect of a ring by definition: every pair of edges whose boxes meet is tested for common points. nullopt:
/// the ring is simple.
std::optional<validation::RingDefect> ring_defect(const IntegerRing& ring);

}  // namespace touchstone::oracle
