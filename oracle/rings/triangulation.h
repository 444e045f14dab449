// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/polygons.h"
#include "oracle/rings/whole.h"
#include "oracle/truth.h"

/// Triangulations and partitions of simple rings, on integers.
namespace touchstone::oracle {

/// Lists of indices in a ring.
using IndexLists = std::vector<std::vector<Index>>;

/// The ring in integers; refuses rings that are not simple polygons.
IntegerRing simple_ring(const Polygon2d& polygon);
IntegerRing simple_ring(const Polygon2<Rational>& polygon);

/// The ring's vertices counter-clockwise.
std::vector<Index> counter_clockwise(const IntegerRing& ring);

/// A triangulation of a simple ring, diagonal by diagonal.
IndexLists triangulated(const IntegerRing& ring);

/// The truth that a ring can be cut into these pieces: the margin is the least magnitude of twice the area of three
/// consecutive vertices, the certificate "pieces" has the `doubled_area` of the ring.
Truth<IndexLists> cut(IntegerRing ring, IndexLists pieces);

/// The defect of the claim that these convex counter-clockwise pieces are a simple polygon, cut along diagonals; "" if
/// it is right.
std::string partition_defect(const Polygon2d& polygon, const IndexLists& pieces);

}  // namespace touchstone::oracle
