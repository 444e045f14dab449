// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polyhedra.h"
#include "robust/hulls/surface.h"

namespace touchstone::robust::hulls {

/// The faces of a finished surface: coplanar facets form one convex polygon of extreme points only, fanned from its
/// corner of least index. Triangles begin with their least index and are sorted by their indices, so that the list does
/// not depend on how the surface grew.
std::vector<Face> faces_of(const Surface& surface, std::size_t threads = 1);

}  // namespace touchstone::robust::hulls
