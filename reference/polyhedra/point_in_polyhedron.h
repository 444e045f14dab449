// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/polyhedra.h"

namespace touchstone::reference {

/// Locates a point relative to the solid within a closed mesh, convex or not, by the ray test.
///
/// Deck p. 53 asks it of convex polyhedra, by sides of faces; pp. 14-15 ask it of polygons that need not be convex, by
/// a ray. No page has both: this is that ray test in space, with the faces' sides. The ray runs from the point to +x.
/// Seen along it, the sides of a face's edges are
///     S = (b.y - a.y) (p.z - a.z) - (b.z - a.z) (p.y - a.y)
/// and the same of b, c and of c, a. The ray's line meets the face if no two S differ in sign; the face lies ahead of
/// the point if E = ((b - a) x (c - a)) . (p - a) has not the sign of the S. Inside where the ray meets an odd number
/// of faces; a point of a face, E = 0, is `boundary`. A face along the ray, all S = 0, is passed over.
///
/// mesh, point: any unit of length, the same for both. The mesh is closed: every edge, a pair of vertices in whichever
/// order, is in an even number of faces. That is all: faces may turn either way, lie twice in the list, be without
/// area, cross or cover each other; there may be several parts, one within another, and vertices of no face. Inside is
/// what a ray in general position leaves through an odd number of faces, so a shell within a shell is a hollow. The
/// union of all faces is the boundary, also where it separates nothing (a face that is there twice, one without area: a
/// segment or a point).
///
/// Degenerate: refused by robust and oracle with field and rule, the first that applies: NaN or infinity in the mesh
/// (mesh.vertices[i][c], "finite number"), or in the point (point[c], "finite number"); a face that names no vertex
/// (mesh.faces[i][k], "index of a vertex"), or one twice (mesh.faces[i], "three different vertices"); fewer than 4
/// faces (mesh, "at least 4 faces"); an edge in an odd number of faces (mesh.faces[i], "closed: the edge ...").
///
/// In exact arithmetic the formula is right where no S is 0. A ray through an edge or a vertex is counted once for
/// every face that has it, and of a point on a face along the ray nothing is said.
///
/// Margin: the least squared distance of the point from a face.
///
/// Rounding (binary64, to nearest, u = 2^-53): let Q be the sum of the magnitudes of the two products in an S, taken
/// exactly. A product goes through two differences, itself and a difference, so S as computed is off by at most ((1 +
/// u)^4 - 1) Q < 4 (1 + 2u) u Q, and by 2^-1073 where products underflow, unless something overflows. E is off by at
/// most 8 (1 + 4u) u P + 2^-1073 (|x| + |y| + |z| + 2), as in point_in_convex_polyhedron.h. If every |S| and |E|
/// exceeds that, the double version is right.
template <class Real>
Location point_in_polyhedron(const Mesh<Real>& mesh, const Point3<Real>& point) {
  const auto side = [&point](const Point3<Real>& a, const Point3<Real>& b) {
    return Real(Real((b.y - a.y) * (point.z - a.z)) - Real((b.z - a.z) * (point.y - a.y)));
  };
  bool inside = false;
  for (const Face& face : mesh.faces) {
    const Point3<Real>&a = mesh.vertices[face.a], &b = mesh.vertices[face.b], &c = mesh.vertices[face.c];
    const Real s = side(a, b), t = side(b, c), r = side(c, a);
    const bool left = s > Real(0) || t > Real(0) || r > Real(0), right = s < Real(0) || t < Real(0) || r < Real(0);
    if (left == right) continue;  // off the ray's line, or along it
    const Real e = dot(cross(b - a, c - a), point - a);
    if (e == Real(0)) return Location::boundary;
    if ((e < Real(0)) == left) inside = !inside;
  }
  return inside ? Location::inside : Location::outside;
}

}  // namespace touchstone::reference
