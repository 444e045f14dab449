// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "catalogue/families/draw_stream.h"
#include "geometry/polyhedra.h"

/// Closed meshes, each with a point at a place where its faces are hard to ask about, drawn from a draw stream.
namespace touchstone::catalogue {

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
