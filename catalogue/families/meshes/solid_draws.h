// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/draw_stream.h"
#include "geometry/polyhedra.h"

/// Closed meshes that need not be convex, drawn from a draw stream; the simplest is a tetrahedron with a dent.
/// Coordinates are multiples of 12, so that middles of edges and of faces are integers.
namespace touchstone::catalogue {

/// A tetrahedron with a dent, a few cubes side by side (an angle, a ring, any), cubes around a hollow, a convex solid
/// within another or next to it. Perhaps some faces reversed.
Meshd lattice_solid(DrawStream& draws);

/// The faces of one to four tetrahedra over a few lattice points: they cross, cover each other, lie within each other,
/// are flat.
Meshd tetrahedra_together(DrawStream& draws);

/// Two to four tetrahedra, each with one vertex, or perhaps two, in common with the one before.
Meshd sheets_at_a_vertex(DrawStream& draws);

/// A tetrahedron whose face away from vertex 0 is replaced by three that meet in `dent`.
Meshd dented_tetrahedron(double size, const Point3d& dent);

/// One of those that test vectors name (catalogue/families/meshes/named_meshes.h), not convex.
const Meshd& named_solid(DrawStream& draws);

/// One of those with more than 256 vertices (named_meshes.h).
const Meshd& long_solid(DrawStream& draws);

/// Faces that separate nothing: twice the same, without area, or an edge cut on one side only, with a face without area
/// in between.
Meshd with_needless_faces(Meshd mesh, DrawStream& draws);

/// Two more faces, the last of the list, with the same corners in any order: those of a face of the mesh, any three
/// points, or three on one line.
Meshd with_face_listed_twice(Meshd mesh, DrawStream& draws);

/// A mesh with an edge in an odd number of faces, or one that breaks another rule; sometimes intact.
Meshd opened(Meshd mesh, DrawStream& draws);

Meshd ordinary_solid(DrawStream& draws);

/// A tetrahedron over the first four vertices, a dented one over the first five; fewer stay as they are.
void make_solid(Meshd& mesh);

}  // namespace touchstone::catalogue
