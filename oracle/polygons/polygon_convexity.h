// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth, by definition: degenerate if neighbours coincide or every triangle from vertex 0 is flat; not simple if any
/// two of all pairs of edges meet where they must not; convex if every vertex is on one closed side of every edge's
/// line. The orientation is the sign of the area.
///
/// Margin, the square of a length: how far vertices are from where the answer changes. Simple rings: the least distance
/// of a vertex from an edge that it does not end, and from the line through its neighbours - for a concave ring only
/// the greatest of those that make it concave. Rings that are not simple: of all pairs of edges that meet, the one that
/// is furthest from coming apart (the least distance of an end of one from the other). Degenerate: 0.
template <Exact Number = double>
Truth<PolygonConvexity> polygon_convexity(const Polygon2<Number>& polygon);

}  // namespace touchstone::oracle
