// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/polyhedra.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// Tests whether the interiors of the solids within two closed meshes have a common point, in exact integers. Requires
/// finite numbers, and both meshes closed in the sense of reference/polyhedra/point_in_polyhedron.h.
///
/// If they do, walk from such a point straight on, avoiding all edges, until one of the two is left: through a face,
/// one side of which is inside of both. Walk on along this face, on its side inside of both, until that ends: at an
/// edge of the face, or where another face meets it. So there is a segment, an edge or the common part of two faces,
/// with a point in general position around which some sector is inside of both. Therefore every such segment is cut
/// where faces begin, end or cross, and at a point in each piece the half-planes of all faces there are sorted around
/// it. A ray that avoids all edges classifies the sector in which it leaves; each half-plane is a step out of its
/// solid, or into it.
bool have_common_interior(const Meshd& a, const Meshd& b);

}  // namespace touchstone::robust::kernel
