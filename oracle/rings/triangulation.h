// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/polygons.h"
#include "oracle/rings/whole.h"

/// Triangulations and partitions of simple rings, on integers.
namespace touchstone::oracle {

/// Lists of places in a ring.
using IndexLists = std::vector<std::vector<Index>>;

/// The ring in integers; what is not a simple polygon is refused.
WholeRing simple_ring(const Polygon2d& polygon);
WholeRing simple_ring(const Polygon2<Rational>& polygon);

/// The ring's vertices counter-clockwise.
std::vector<Index> counter_clockwise(const WholeRing& ring);

/// A triangulation of a simple ring, diagonal by diagonal.
IndexLists triangulated(const WholeRing& ring);

/// The least size of twice the area of three consecutive vertices, in squares of the unit of the input.
Rational least_turn(const WholeRing& ring);

/// What is wrong with the claim that these convex counter-clockwise pieces are a simple polygon, cut along diagonals;
/// "" if it is right.
std::string partition_fault(const Polygon2d& polygon, const IndexLists& pieces);

}  // namespace touchstone::oracle
