// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/polyhedra.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/strict_math.h"

/// Tests whether the faces of a valid mesh have areas, and meet in common edges and corners only.
/// reference/polyhedra/polyhedron_complexity.h defines the terms.
namespace touchstone::robust::structures {

/// The first face without an area.
std::optional<Index> first_flat_face(const Meshd& mesh);

/// The first pair of faces, in ascending order, that meet beyond these; all faces have areas. Tests the pairs of
/// robust/structures/near_faces.h. surface: the mesh is a closed oriented manifold; then faces around a vertex that are
/// a graph over a coordinate plane need no test. Most others are separated by a plane perpendicular to an axis or by
/// the plane of one of them; the rest cost some microseconds each, in GMP's integers.
std::optional<IndexPair> first_meeting_faces(const Meshd& mesh, bool surface);

}  // namespace touchstone::robust::structures
