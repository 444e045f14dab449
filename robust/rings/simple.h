// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/validation.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// The first defect of a ring of finite vertices, exactly; empty: the ring is simple, which a sweep tells in time n log
/// n. The first defect of a ring that is not is found by comparing edges whose boxes meet, along the axis on which
/// fewer do, and as soon as one is known no pair of later edges.
std::optional<validation::RingDefect> ring_defect(const Polygon2d& ring);

}  // namespace touchstone::robust
