// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/complexity.h"
#include "geometry/invalid_input.h"
#include "geometry/polyhedra.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// Counts the vertices, edges, faces and components of a mesh; tests whether it is closed, oriented, a manifold at its
/// edges and at its vertices, embedded (no face without area, no two faces that meet beyond what they share) and
/// convex, each with the first place where it is not; computes the sign of its volume, and which component contains
/// which.
///
/// Right for all finite doubles in every floating-point environment; nothing is rounded. NaN and infinities throw
/// InvalidInput, and so does a face that is not a triangle of the mesh. Faces share vertices by index: merge repeated
/// positions first. Contract: reference/polyhedra/polyhedron_complexity.h.
///
/// Time: n log n, and a test for each pair of triangles whose boxes meet; around a vertex of many triangles, for each
/// pair whose directions from there meet (robust/structures/near_faces.h). A closed embedded mesh that is not convex
/// costs a test of all vertices for each face before the first that has vertices on both sides; a mesh of several
/// components a test of the faces of each for every component whose box meets its own.
PolyhedronComplexity<double> polyhedron_complexity(const Meshd& mesh);

}  // namespace touchstone::robust
