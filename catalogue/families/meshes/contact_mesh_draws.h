// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/draw_stream.h"
#include "geometry/polyhedra.h"

/// Meshes whose faces touch, cross, cover or contain each other, drawn from a draw stream: what an embedded mesh must
/// not have, and what it may. Coordinates are integers but for what people reported.
namespace touchstone::catalogue {

/// Four to seven triangles over some of the points of {0, 1, 2}^3: they share corners and edges, lie in one plane,
/// cross, touch, have no area.
Meshd small_lattice_faces(DrawStream& draws);

/// A triangle of any plane, cut into equal ones: flat, and embedded, until a vertex is moved, in its plane or off it.
Meshd flat_part(DrawStream& draws);

/// A tetrahedron over a triangle, and a flap on one of the triangle's edges: folded back on it, in its plane on the
/// other side, or off the plane.
Meshd folded_flap(DrawStream& draws);

/// Two tetrahedra without a common index. A vertex of one is a vertex of the other, or on its edge, on its face, or
/// near.
Meshd touching_solids(DrawStream& draws);

/// Triangles that all have vertex 0 at a corner: their sectors cross, touch, cover each other, or do not.
Meshd fans_at_a_vertex(DrawStream& draws);

/// Two tetrahedra in opposite octants that have vertex 0 in common and nothing else: convex everywhere but there.
Meshd convex_at_a_vertex(DrawStream& draws);

/// One to four convex shells around one point, or moved away from it: one within another in any order, some turned
/// over; coincident; or a cube in the hollow of a cube.
Meshd nested_shells(DrawStream& draws);

/// The mesh as a file of triangles without indices has it: each face with three vertices of its own, or some faces.
Meshd with_repeated_vertices(const Meshd& mesh, DrawStream& draws);

/// Pairs of faces that a library was reported to be wrong about (reported_triangles.h), next to a tetrahedron.
Meshd reported_faces(DrawStream& draws);

/// Each axis times a power of two of its own, past the lattice, past the filters' guards.
Meshd with_stretched_axes(Meshd mesh, DrawStream& draws);

}  // namespace touchstone::catalogue
