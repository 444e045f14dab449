// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the plane is cut into vertical slabs at every vertex and at every crossing of an edge of a with an edge of b.
/// Inside a slab nothing crosses, so the polygons have a common interior point exactly if on the middle line of some
/// slab an interval of a and one of b overlap. Without that they touch where two edges have a common point. Margin: the
/// least squared distance of a vertex of one from an edge of the other; 0 for every contact in a vertex. For `disjoint`
/// that is the squared distance of the two polygons.
///
/// Certificate: overlapping: "common_interior_point" (`point`, its x not that of a vertex: the vertical line upwards
/// from it counts). touching: "slabs" (`cuts`, ascending) and a common `point`. disjoint: "slabs" alone.
Truth<Contact> polygon_polygon(const Polygon2d& a, const Polygon2d& b);
Truth<Contact> polygon_polygon(const Polygon2<Rational>& a, const Polygon2<Rational>& b);

}  // namespace touchstone::oracle
