// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/polyhedra.h"

namespace touchstone::reference {

/// Locates a point relative to a convex polyhedron, by the side of each face.
///
/// Deck p. 53: a point is inside where it is on the inside of all faces. The side of a face a, b, c is the sign of
///     E = ((b - a) x (c - a)) . (p - a),
/// which is positive where the face is seen counter-clockwise. Inside where all E have one sign, outside where two have
/// different ones; E = 0, on which the slide is silent, is `boundary`, unless two others differ.
///
/// mesh, point: any unit of length, the same for both. Faces counter-clockwise from outside; a mesh that is entirely
/// inside out is the same solid. Any number of faces in one plane, flat vertices, vertices of no face and several
/// vertices in one position are valid.
///
/// Degenerate: none is valid. Refused by robust and oracle with field and rule, the first that applies: NaN or infinity
/// in the mesh (mesh.vertices[i][c], "finite number"), or in the point (point[c], "finite number"); a face that names
/// no vertex (mesh.faces[i][k], "index of a vertex"), or one twice (mesh.faces[i], "three different vertices"); fewer
/// than 4 faces (mesh, "at least 4 faces");
/// an edge a -> b of a face that another face has too, or whose reverse b -> a is not in exactly one face
/// (mesh.faces[i], "closed: edge ..."); a face of area zero (mesh.faces[i], "nonzero area"); all vertices on one plane
/// (mesh, "convex: vertices on one plane have no inside"); a vertex on the outer side of a face's plane (mesh.faces[i],
/// "convex: vertex ... must not lie beyond its plane"), where the inner side of all faces is that on which the first
/// vertex lies that is not on the plane of face 0. To find that out the oracle tests every face with every
/// vertex, which is most of its time; robust tests the edges, and every vertex only if these do not tell.
///
/// By these rules the solid is at once the intersection K of the faces' closed inner half-spaces and the convex hull H
/// of the vertices. All vertices are in K, so H is. H has an inside, and every face lies, with an area, in a plane that
/// has all of H on one side: it is a part of a facet of H, and all faces have the same orientation as seen from outside
/// H. Walk on the surface of H, past its vertices: across an edge a -> b the number of faces above one's feet loses
/// those on the left of a -> b and gains those on the left of b -> a, which are as many. So that number is the same
/// everywhere on H, and not 0, because there is a face. Hence every facet of H has a face in its plane, and K, within
/// all these planes, is in H. (The number may be greater than 1: a surface that goes round its solid twice bounds the
/// same solid.)
///
/// In exact arithmetic the formula is always right: the sum of all E is six times the volume (times that number),
/// wherever the point is, so that some E has the sign of the inside; and where none has the other sign, the point is in
/// all the half-spaces.
///
/// Margin: the squared distance of the point from a face's plane, the nearest one from inside, the farthest of those
/// that it is beyond from outside.
///
/// Rounding (binary64, to nearest, u = 2^-53): let P be the sum of the magnitudes of the six products of three
/// differences in an E, taken exactly. A product goes through three differences, two products, a difference and two
/// sums, so E as computed is off by at most ((1 + u)^8 - 1) P < 8 (1 + 4u) u P; where products underflow, by 2^-1073
/// (|x| + |y| + |z| + 2) more, with p - a = (x, y, z); unless something overflows. If every |E| exceeds that, the
/// double version is right.
template <class Real>
Location point_in_convex_polyhedron(const Mesh<Real>& mesh, const Point3<Real>& point) {
  bool front = false, back = false, on = false;
  for (const Face& face : mesh.faces) {
    const Point3<Real>&a = mesh.vertices[face.a], &b = mesh.vertices[face.b], &c = mesh.vertices[face.c];
    const Real e = dot(cross(b - a, c - a), point - a);
    if (e > Real(0)) front = true;
    else if (e < Real(0)) back = true;
    else on = true;
  }
  return front && back ? Location::outside : on ? Location::boundary : Location::inside;
}

}  // namespace touchstone::reference
