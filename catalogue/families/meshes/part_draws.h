// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <utility>

#include "catalogue/families/draw_stream.h"
#include "geometry/polyhedra.h"

/// Closed meshes of several parts, and points at places where faces are hard to ask about, drawn from a draw stream.
/// Coordinates are integers.
namespace touchstone::catalogue {

/// Three to five shells, 2, 4, 6 ... times as large as a convex `shape` around the origin: a solid, a hollow, a solid.
/// An odd multiple of the shape lies between two of them. The parts are in any order, some of them inside out.
Meshd shells(const Meshd& shape, DrawStream& draws);

/// A solid with a hollow, a notch or a hole, the cell of size 12 whose middle is `middle`; and a box, an octahedron or
/// a tetrahedron that is free in there, touches the walls, fills all of it or reaches into the solid.
struct BodyInRecess {
  Meshd solid, body;
  Point3d middle;
};
BodyInRecess body_in_recess(DrawStream& draws);

/// Two or three boxes, from 0 to 60 in multiples of 12, that cross, cover or contain each other around (30, 30, 30):
/// what two of them have in common is outside.
Meshd crossing_boxes(DrawStream& draws);

/// The box between two corners.
Meshd box_mesh(const Point3d& min, const Point3d& max);

/// One to three more vertices that no face names, before or after the others: far away, or at `place`.
Meshd with_unnamed_vertices(Meshd mesh, const Point3d& place, DrawStream& draws);

/// Meshes, each with a point at a place where its faces are hard to ask about.
using MeshAndPoint = std::tuple<Meshd, Point3d>;

/// On a face plane of tetrahedra that cross, or between two vertices; or moved from there along x.
MeshAndPoint place_at_tetrahedra(DrawStream& draws);

/// Between a vertex and a face plane of a solid that also has faces that separate nothing.
MeshAndPoint place_at_needless_faces(DrawStream& draws);

/// On a face that is listed twice, or moved from there along x.
MeshAndPoint place_at_face_listed_twice(DrawStream& draws);

/// On a face, but for rounding.
MeshAndPoint rounded_place_on_face(DrawStream& draws);

/// On one of the shells, or between two of them.
MeshAndPoint place_in_shells(DrawStream& draws);

/// In a recess, where another body is.
MeshAndPoint place_in_recess(DrawStream& draws);

/// On the grid of 6 on which boxes cross.
MeshAndPoint place_in_crossing_boxes(DrawStream& draws);

/// Around the last vertices for the most part; so the faces that decide come late in the list.
MeshAndPoint place_at_long_solid(DrawStream& draws);

}  // namespace touchstone::catalogue
