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
/// robust/structures/near_faces.h. Most of these are separated by a plane perpendicular to an axis or by the plane of
/// one of them; the others cost some microseconds each, in GMP's integers: neighbours in an oblique common plane, and
/// those around the vertex of a saddle.
std::optional<IndexPair> first_meeting_faces(const Meshd& mesh);

}  // namespace touchstone::robust::structures
