// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "geometry/polyhedra.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/strict_math.h"

/// Which triangles of a mesh are to be looked at in pairs, also where many of them share a vertex.
namespace touchstone::robust::structures {

/// Calls look(i, j), i < j, once for each pair of triangles that may have more in common than one vertex which both
/// name. All have areas; boxes: of each triangle the least that holds it.
///
/// Triangles whose boxes are apart have nothing in common. The boxes of triangles around a vertex all hold it, so those
/// around a vertex of many triangles are compared by the directions in which they leave it: a triangle that has this
/// vertex holds the beginning of each ray from there through its opposite edge, so two of them have nothing but the
/// vertex in common if no direction is in both. Time: n log n, and the pairs that are left.
void look_at_near_faces(const Meshd& mesh, const std::vector<Aabb3d>& boxes,
                        const std::function<void(Index i, Index j)>& look);

}  // namespace touchstone::robust::structures
