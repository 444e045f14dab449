// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/complexity.h"
#include "geometry/polyhedra.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: from the definitions: sets of vertices and edges; components by walking from face to face; at every vertex a
/// walk through its faces, which has to come past all of them; for each pair of triangles whose boxes meet a plane
/// between them, across an axis, that of one of the two, upright on an edge of one, or by an exact linear program
/// (oracle/exact/solids/two_faces.h); every vertex against the plane of every face; the sum of the prisms under the
/// faces; the place of a vertex of each component in every other one, by rays (oracle/exact/solids/solid.h). Margin:
/// none: several quantities decide several words.
///
/// Certificate: "complexity": what indices tell is counted once more, and so are areas, sides of planes and the volume.
/// normals: of a plane for each pair of faces before the meeting ones that neither a plane across an axis nor the
/// faces' own planes hold apart. common_point: six weights of the corners of the meeting faces.
/// directions: of a ray that misses all edges, for each two components of which the first vertex of the one is in the
/// box of the other.
template <Exact Number = double>
Truth<PolyhedronComplexity<Rational>> polyhedron_complexity(const Mesh<Number>& mesh);

}  // namespace touchstone::oracle
