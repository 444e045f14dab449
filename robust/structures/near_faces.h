// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "geometry/polyhedra.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/strict_math.h"

/// The pairs of triangles of a mesh that need testing, even if many of them share a vertex.
namespace touchstone::robust::structures {

/// Calls look(i, j), i < j, once for each pair of triangles that may have more in common than one shared vertex. All
/// have areas; boxes: for each triangle the least box that contains it.
///
/// Triangles with disjoint boxes have nothing in common. The boxes of triangles around a vertex all contain it, so
/// those around a vertex of many triangles are compared by the directions in which they leave it: a triangle with this
/// vertex contains the beginning of each ray from there through its opposite edge, so two of them have nothing but the
/// vertex in common if they share no direction. Time: n log n, and the remaining pairs.
void look_at_near_faces(const Meshd& mesh, const std::vector<Aabb3d>& boxes,
                        const std::function<void(Index i, Index j)>& look);

}  // namespace touchstone::robust::structures
