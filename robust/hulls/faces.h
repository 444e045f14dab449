// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polyhedra.h"
#include "robust/hulls/surface.h"

namespace touchstone::robust::hulls {

/// The faces of a surface that is done: what lies in one plane is one convex polygon, of extreme points alone, and is
/// cut from its corner of the least place. Triangles begin with their least place and come in the order of their
/// places: the same list, whichever way the surface grew.
std::vector<Face> faces_of(const Surface& surface);

}  // namespace touchstone::robust::hulls
