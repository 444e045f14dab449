// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/ray_mesh.h"
#include "reference/sweeps/swept_sphere_triangle.h"

namespace touchstone::reference {

/// Finds when a ball that moves along a straight line first has a common point with the faces of a mesh, by the formula
/// of swept_sphere_triangle.h for one face after another.
///
/// No page of the deck asks this. It is p. 23's first time of a step and p. 54's face, edges and corners, for each of
/// the faces. The least t counts, and of equal ones the first face. sphere, mesh: any unit of length, the same for
/// both; velocity in that unit a step, of the ball, while the mesh rests; t counts in steps. The mesh is a list of
/// triangles over a list of vertices, and nothing more: open or closed, of any number of parts, crossing itself. It is
/// the surface, not a solid within it: a ball inside a closed mesh, farther than its radius from all faces, has nothing
/// in common with it. Faces have two sides; vertices that no face names are not met. Closed sets: touching is a hit,
/// also where the ball only grazes a face, slides along it, or touches it at the start or at the end. The truth is
/// `hit` with the first t in [0, 1] where the ball and some face have a common point, 0 if they have one at the start,
/// and the least index of the faces that have one with the ball then; t is in general a number with a square root, and
/// times are compared as they are, not as they are rounded. Where the ball meets an edge or a corner first, all of its
/// faces are met at once. A mesh without faces is met never.
///
/// Degenerate: a face without area, also one that names a vertex twice, is the segment or the point that its corners
/// span; radius 0 is a point; a velocity of 0 is valid. Refused by robust and oracle with field and rule, the first
/// that applies: NaN or infinity (sphere.center[c], sphere.radius, velocity[c], mesh.vertices[i][c], "finite number");
/// a negative radius ("sphere.radius", "radius >= 0"); a face that names no vertex (mesh.faces[i][k], "index of a
/// vertex"). A face of more than three corners is the polygon that they bound: it is cut into triangles first, and
/// refused by the rules of docs/meshes.md before everything else.
///
/// In exact arithmetic the formula is always right, as it is for each face. (Roots are then exact to 9000 digits: where
/// two faces are met at one irrational time, which different polynomials have, the judge may blame the formula.)
///
/// Margin: with a hit at the start the least |d^2 - r^2| of the triangles up to the first that is met, d being the
/// distance of the center from one; otherwise the least of the margins that swept_sphere_triangle.h has for the
/// triangles, or 0 if the named face is not the only one that is met at t, which includes edges and corners that faces
/// share. A face of more corners counts as the triangles of its cut.
///
/// Rounding: no bound is given, as for one face; where two faces are met within what is rounded, either may be named.
/// ulps: 53 roundings behind t, as in swept_sphere_triangle.h.
template <class Real>
FirstFaceContact<Real> swept_sphere_mesh(const Sphere3<Real>& sphere, const Vector3<Real>& velocity,
                                         const Mesh<Real>& mesh) {
  FirstFaceContact<Real> first{HitRelation::never, std::nullopt, std::nullopt};
  for (Index i = 0; i < mesh.faces.size(); ++i) {
    const FirstContact<Real> contact = swept_sphere_triangle(sphere, velocity, triangle_of_face(mesh, i));
    if (contact.t && !(first.t && *first.t <= *contact.t)) first = {HitRelation::hit, contact.t, i};
  }
  if (first.face) first.face = named_face_of(mesh, *first.face);
  return first;
}

}  // namespace touchstone::reference
