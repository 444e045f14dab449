// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/door.h"

namespace touchstone::robust {

/// The first defect of a ring of finite vertices, exactly; empty: the ring is simple. The edges are swept by their least x, so that only
/// those are compared whose boxes meet: near-linear unless many long edges lie side by side.
std::optional<door::RingDefect> ring_defect(const Polygon2d& ring);

}  // namespace touchstone::robust
