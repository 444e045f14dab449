// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/validation.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// The first defect of a ring of finite vertices, exactly; nullopt: the ring is simple, which a sweep decides in time n
/// log n. The first defect of a ring that is not simple is found by comparing edges whose boxes meet, along the axis on
/// which fewer do; once one is known, pairs of later edges are skipped.
std::optional<validation::RingDefect> ring_defect(const Polygon2d& ring);

}  // namespace touchstone::robust
