// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "geometry/answers.h"
#include "robust/kernel/filters/staged.h"
#include "robust/structures/ring_tree.h"

namespace touchstone::robust {

/// The boundary of an area: simple rings with the inside to their left, of which any two meet in single points at most:
/// for a polygon one ring, counter-clockwise; for a region also its holes, clockwise.
using Rings = std::span<const structures::TreedRing* const>;

/// The meaning of two edges that have a piece in common and their insides on different sides.
enum class CommonEdge { touches, overlaps };

/// The contact of two areas as far as their boundaries meet: `overlapping` if next to a common point of the boundaries
/// there are points inside both, `touching` if the boundaries meet, `disjoint` otherwise. Must be called with gradual
/// underflow (kernel/filters/control_word.h).
Decided<Contact> contact_of_boundaries(Rings a, Rings b, CommonEdge common);

/// Locates a point among the edges of a simple ring, for a few points; under the same condition.
Location located_by_turns(const structures::TreedRing& ring, const Point2d& p);

}  // namespace touchstone::robust
