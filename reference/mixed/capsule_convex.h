// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/capsules.h"
#include "reference/mixed/sphere_convex.h"

namespace touchstone::reference {

/// Decides whether a capsule and a convex polyhedron, as closed solids, overlap, only touch, or neither.
///
/// No page of the deck asks this. The formula is that of sphere_convex for the segment instead of the center.
/// capsule, mesh: any unit of length, the same for both. Shapes are closed: where one only reaches the other they are
/// `touching`. One within the other overlaps it. A radius of 0 (or -0) is valid: such a capsule is a segment, which has
/// no interior, and the truth is `touching` at most. A segment of length 0 is valid: the capsule is a ball. Which
/// meshes are valid stands in reference/polyhedra/point_in_convex_polyhedron.h.
/// Refused by robust and oracle, the first that applies: NaN or infinity ("capsule.segment[0][0]",
/// "mesh.vertices[0][0]" ..., "finite number"); a negative radius ("capsule.radius", "radius >= 0"); what is not the
/// surface of a convex solid, by the rules and in the order of that page, with "mesh" for the mesh.
///
/// In exact arithmetic the formula is right. Rounding: as in sphere_convex, W and M being those of the segment and of
/// the mesh. No number is returned.
template <class Real>
Contact capsule_convex(const Capsule3<Real>& capsule, const Mesh<Real>& mesh) {
  return contact_with_convex<Real>({{capsule.segment.a, capsule.segment.b}, {}, {}}, capsule.radius, mesh);
}

}  // namespace touchstone::reference
