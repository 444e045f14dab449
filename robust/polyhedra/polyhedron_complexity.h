// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/complexity.h"
#include "geometry/invalid_input.h"
#include "geometry/polyhedra.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// How many vertices, edges, faces and components a mesh has; whether it is closed, oriented, a manifold at its edges
/// and at its vertices, embedded (no face without area, no two faces that meet beyond what they share) and convex, each
/// with the first place where it is not; the sign of its volume; which component contains which.
///
/// Right for all finite doubles in every floating-point environment; nothing is rounded. NaN and infinities throw
/// InvalidInput, and so does a face that is no triangle of the mesh. Faces share the vertices that they name: merge
/// repeated positions first. Contract: reference/polyhedra/polyhedron_complexity.h.
///
/// Time: n log n, and a look at each pair of triangles whose boxes meet; of those around a vertex of many, whose
/// directions from there meet (robust/structures/near_faces.h). A closed embedded mesh that is not convex costs a look
/// at all vertices for each face before the first that has vertices on both sides; one of several components a look at
/// the faces of each for every component whose box meets its own.
PolyhedronComplexity<double> polyhedron_complexity(const Meshd& mesh);

}  // namespace touchstone::robust
