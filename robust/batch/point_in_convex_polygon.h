// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/polygons.h"
#include "robust/batch/isa/columns.h"

namespace touchstone::robust {
class ConvexPolygon;
}

namespace touchstone::robust::batch {

/// robust::point_in_convex_polygon of one polygon and each point, its Location: inside 0, boundary 1, outside 2. The
/// error of a refused polygon names its field without a row.
void point_in_convex_polygon(const Polygon2d& polygon, const Points2& points, std::size_t count, std::uint8_t* answers,
                             const Limits& limits = {});
/// The same of a polygon that was validated once, by its tree.
void point_in_convex_polygon(const ConvexPolygon& polygon, const Points2& points, std::size_t count,
                             std::uint8_t* answers, const Limits& limits = {});

}  // namespace touchstone::robust::batch
