// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/polyhedra.h"
#include "geometry/volumes.h"
#include "reference/mixed/convex_distance.h"

namespace touchstone::reference {

/// The contact of a convex polyhedron with all that is no farther than a radius from a core, the hull of some points.
template <class Real>
Contact contact_with_convex(const Mesh<Real>& core, const Real& radius, const Mesh<Real>& mesh) {
  const DistanceSimplex<Real> nearest = nearest_simplex(core, mesh);
  const Vector3<Real> beyond = nearest.on_a() - nearest.on_b();
  const Real distance = nearest.pairs.size() == 4 ? Real(0) : dot(beyond, beyond),
             squared_radius = Real(radius * radius);
  return distance > squared_radius   ? Contact::disjoint
         : distance < squared_radius ? Contact::overlapping
                                     : Contact::touching;
}

/// Decides whether a ball and a convex polyhedron, as closed solids, overlap, only touch, or neither.
///
/// No page of the deck asks this. The formula is that of convex_distance (p. 48-50, 53-54: Gilbert, Johnson and
/// Keerthi) for the center alone instead of one of the polyhedra; the square of the distance found is compared with
/// that of the radius. Equal squares are `touching`.
/// sphere, mesh: any unit of length, the same for both. Shapes are closed: where the ball only reaches a face, an edge
/// or a vertex they are `touching`. A ball within the polyhedron overlaps it, and so does a polyhedron within the ball.
/// A radius of 0 (or -0) is valid: such a ball is a point, which has no interior, and the truth is `touching` at most,
/// as in sphere_obb. Which meshes are valid, inside out among them, stands in
/// reference/polyhedra/point_in_convex_polyhedron.h. Vertices of no face are within the solid, and change nothing.
/// Refused by robust and oracle, the first that applies: NaN or infinity ("sphere.center[0]", "mesh.vertices[0][0]"
/// ..., "finite number"); a negative radius ("sphere.radius", "radius >= 0"); what is not the surface of a convex
/// solid, by the rules and in the order of that page, with "mesh" for the mesh.
///
/// In exact arithmetic the formula is right, as that of convex_distance is.
///
/// Rounding (binary64, to nearest, u = 2^-53): where nothing overflows and the simplex found has fewer than four pairs,
/// both points are, on each axis, within 16 u (W + M) + 2^-1070 of a point of their solids, as convex_distance has it;
/// W and M are those of the mesh, and for the center, which is found exactly, W is 0. Let e be the sum of these over
/// both and all axes. As in capsule_capsule, where the distance of the center from the solid exceeds e + (1 + 8u) R +
/// 2^-535, R being the radius, the double version answers `disjoint`, and is right. In the other direction nothing is
/// promised, nor where the simplex has four pairs: flat ones may seem to hold the center. No number is returned.
template <class Real>
Contact sphere_convex(const Sphere3<Real>& sphere, const Mesh<Real>& mesh) {
  return contact_with_convex<Real>({{sphere.center}, {}, {}}, sphere.radius, mesh);
}

}  // namespace touchstone::reference
