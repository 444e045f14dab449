// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/polyhedra.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// Whether the interiors of the solids within two closed meshes have a common point, in exact integers. Of finite
/// numbers, and both closed as reference/polyhedra/point_in_polyhedron.h says.
///
/// If they do, walk from there straight on, past all edges, until one of the two is left: through a face, on which one
/// side is inside of both. Walk on in this face, beside it inside of both, until that ends: at an edge of it, or where
/// another face meets it. So there is a segment, an edge or the common part of two faces, and on it a point in general
/// position, around which some sector is inside of both. So every such segment is cut where faces begin, end or pass,
/// and somewhere in each piece the half-planes of all faces there are put in order around it. One sector is known
/// from a ray that leaves in it past all edges; each half-plane is a step out of its solid, or into it.
bool have_common_interior(const Meshd& a, const Meshd& b);

}  // namespace touchstone::robust::kernel
