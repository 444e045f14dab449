// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/draw_stream.h"
#include "geometry/polyhedra.h"

/// Meshes named by polygons, drawn from a draw stream.
namespace touchstone::catalogue {

/// The same surface with triangles of one plane united across drawn edges, where that makes a valid polygon: concave
/// ones, with corners on edges, around holes along a bridge, touching themselves in a corner. Each polygon begins at
/// any of its corners. Without triangles to unite the mesh stays as it is.
Meshd with_polygons(const Meshd& mesh, DrawStream& draws);

/// The same polygons, which are valid, with other cuts, drawn.
Meshd recut(Meshd mesh, DrawStream& draws);

/// Two triangles more, back to back, on two corners of a polygon and a vertex above it: along one of its diagonals, or
/// of its edges. Or one such triangle before all polygons, where two would meet each other first. Or one without an
/// area.
Meshd with_fin(Meshd mesh, DrawStream& draws);

/// Mostly a mesh that breaks a rule of polygons: a corner off the plane, two corners swapped, a triangle of the cut
/// turned over, named twice or over other corners, a triangle too few.
Meshd with_broken_polygons(Meshd mesh, DrawStream& draws);

/// A solid with coplanar triangles, mostly united to polygons, perhaps with more vertices in edges and faces; the
/// simplest is a cube of squares.
Meshd solid_of_polygons(DrawStream& draws);
/// The same of a convex solid.
Meshd convex_solid_of_polygons(DrawStream& draws);

}  // namespace touchstone::catalogue
