// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/draw_stream.h"
#include "geometry/polyhedra.h"

namespace touchstone::catalogue {

/// The mesh, which is named by polygons with valid cuts, mostly with a wrong cut of one of them, in its plane: over
/// other vertices, those of another face, turned over.
Meshd with_wrong_cut(Meshd mesh, DrawStream& draws);

/// The mesh with one polygon more, whose cut mostly breaks one rule alone: a ring that runs over itself, a corner
/// within a triangle, a triangle without an area, a triangle that begins at another corner than its polygon. Or a valid
/// one that comes back to a position by another vertex.
Meshd with_wrong_polygon(Meshd mesh, DrawStream& draws);

/// The mesh with one polygon more, whose cut is triangles apart from each other over other corners or with another
/// boundary than the polygon's.
Meshd with_foreign_cut(Meshd mesh, DrawStream& draws);

/// The mesh with a corner of a polygon an ulp or two higher or lower: off the plane, unless that is upright.
Meshd with_lifted_corner(Meshd mesh, DrawStream& draws);

}  // namespace touchstone::catalogue
