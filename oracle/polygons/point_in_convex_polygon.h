// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: barycentric weights in the triangles from vertex 0; a point with a negative one in every triangle is outside,
/// and the weights that are 0 tell the boundary. That the polygon is convex is found by definition. Margin: the least
/// squared distance of the point from an edge.
template <Exact Number = double>
Truth<Location> point_in_convex_polygon(const Polygon2<Number>& polygon, const Point2<Number>& point);

}  // namespace touchstone::oracle
