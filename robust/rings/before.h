// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/points.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// Lexicographic order. Call while a kernel::ControlWord is in scope: a flushed denormal would be 0.
inline bool before(const Point2d& p, const Point2d& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

}  // namespace touchstone::robust
