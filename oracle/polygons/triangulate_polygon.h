// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "oracle/rings/triangulation.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: one triangulation of many, diagonal by diagonal on integers. Margin: the least size of twice the area of
/// three consecutive vertices, which is 0 if one is flat: how far the vertices are from changing between convex and
/// reflex.
template <Exact Number = double>
Truth<IndexLists> triangulate_polygon(const Polygon2<Number>& polygon);

/// The defect of a triangulation of a simple polygon; "" if it is right, ours or not.
std::string triangulate_polygon_defect(const Polygon2d& polygon, const IndexLists& triangles);

}  // namespace touchstone::oracle
