// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "catalogue/families/draw_stream.h"
#include "geometry/polygons.h"

/// Regions, drawn from a draw stream as exact numbers; the simplest has no hole.
namespace touchstone::catalogue {

/// Valid: holes within a simple ring, which often touch it or one another in points.
Region2d region(DrawStream& draws);

/// The same with at least one hole.
Region2d region_with_hole(DrawStream& draws);

/// The same as a set: rings turned, and the holes in another order.
Region2d turned_region(Region2d region, DrawStream& draws);

/// One of its rings, or a point of an edge of one.
const Polygon2d& any_ring(const Region2d& region, DrawStream& draws);
Point2d on_an_edge_of(const Region2d& region, DrawStream& draws);

/// A square with a hole that is hardly or not at all within it, or with two that hardly or not at all fit together;
/// often refused.
Region2d fitting_or_not(DrawStream& draws);

/// One of its rings is closed, repeats a vertex or has a spike.
Region2d with_defective_ring(DrawStream& draws);

/// Up to 49 holes in rows, neighbours touching in corners.
Region2d lattice_of_holes(DrawStream& draws);

/// As compute() of rings.h: holes that touch do so but for rounding.
Region2d computed_region(DrawStream& draws);

/// Two regions whose outer rings cross twice where holes touch both. They have a common inside only if the second's
/// hole leaves more than the first's hole takes away.
std::pair<Region2d, Region2d> holes_at_crossings(DrawStream& draws);

/// Undoes crossings of rings, and drops holes that do not fit.
void untangle(Region2d& region);

}  // namespace touchstone::catalogue
