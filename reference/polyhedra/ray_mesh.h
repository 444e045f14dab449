// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/ray_mesh.h"

namespace touchstone::reference {

/// Finds where a ray first meets the faces of a mesh, and how many faces it meets.
///
/// No page of the deck asks this. It is p. 54's edge and face, with p. 9's ray instead of the edge, one face after
/// another, in the form that programs use (Moeller and Trumbore, Fast, minimum storage ray/triangle intersection,
/// 1997): with e = b - a, f = c - a, s = origin - a, p = direction x f and q = s x e,
///     rise = e . p,  ca = s . p,  ab = direction . q,  bc = rise - ca - ab,  height = f . q.
/// The face is met if rise is not 0 and none of the other four has the opposite sign, at t = height / rise. The least t
/// counts, and of equal ones the first face. Its part is `inside` if none of ca, ab and bc is 0, `edge` if one is, and
/// `vertex` if two are.
///
/// ray, mesh: any unit of length, the same for both; t is in units of the direction's length. The mesh is a list of
/// faces over a list of vertices, and nothing more: open or closed, of any number of parts, crossing itself; faces
/// turn either way and are met from both sides; vertices that no face names are not met. Closed sets: the origin,
/// edges and vertices belong to them, so a ray through an edge that two faces share, or a vertex of six, meets all of
/// them. Each triangle is decided as by ray_triangle.h; a face of more corners is the polygon that they bound, and is
/// cut into triangles first. `face` is the least index of the faces that have the first common point, as the mesh names
/// them. `part` is `vertex` where the point is a corner of that face, else `edge` where it is on an edge of it, between
/// two corners that the face names one after the other, and otherwise `inside`. `faces_met` is the number of faces that
/// have any point in common with the ray, also those along it: what Embree's filter functions, trimesh's intersects_id
/// and libigl's ray_mesh_intersect list, if neither rounding nor a convention leaves out a face. It is not the number
/// of crossings of a surface: that is the same only where no edge, no vertex and no face along the ray is met. A mesh
/// without faces is met nowhere.
///
/// Degenerate: a face without area, also one that names a vertex twice, is the segment or the point that its corners
/// span, and has no inside: its points are at its vertices or on its edges. A face in whose plane the ray lies is met
/// at the first t of what they have in common; if the origin is in the face that is 0, `inside`. Refused by robust and
/// oracle with field and rule, the first that applies: NaN or infinity in the ray (ray.origin[c], ray.direction[c],
/// "finite number"), or in the mesh (mesh.vertices[i][c], "finite number"); a direction of length 0 ("ray.direction",
/// "nonzero direction"); a face that names no vertex (mesh.faces[i][k], "index of a vertex"). Faces of more than three
/// corners are refused by the rules of docs/meshes.md before everything else. t and the point are infinite if the exact
/// ones are beyond the range of doubles.
///
/// In exact arithmetic the formula misses faces without area and those in whose plane the ray lies, takes a diagonal of
/// the cut of a face for an edge, and passes over a bridge within a face (cause: algorithm). It is right about all
/// others.
///
/// Margin: the least squared distance of the origin from a triangle, or of the ray from an edge of one, diagonals of
/// cuts included, or of the first point from the one at which the ray first meets another face.
///
/// Rounding (binary64, to nearest, u = 2^-53): with X, Y and Z the sums of the magnitudes of the coordinates of e, f
/// and s on each axis, taken exactly, the products of rise, ca, ab and bc are among those of T = |v.x| Y Z + |v.y| Z X
/// + |v.z| X Y, each at most once, those of height among those of X Y Z. A product goes through at most nine roundings
/// (two differences of points, a product, a difference in the cross product, a product, two sums, two differences), so
/// each value is off by at most ((1 + u)^9 - 1) T < 9 (1 + 5u) u T, and by 2^-1073 (|v.x| + |v.y| + |v.z| + X + Y + Z +
/// 3) where products underflow, unless something overflows. A face is certain if rise exceeds its bound, and so does
/// one other value of the opposite sign, or do all others. If all faces are certain, relation and faces_met are right
/// in double, part is `inside`, and t is off by no more than the greatest error of the quotient height / rise of a face
/// that is met. Nothing is promised of the face where two faces are met within that.
/// ulps: 29 roundings behind t, 31 behind each coordinate of the point, as in ray_triangle.h.
template <class Real>
RayMesh<Real> ray_mesh(const Ray3<Real>& ray, const Mesh<Real>& mesh) {
  RayMesh<Real> found{PassageRelation::none, std::nullopt, 0};
  const Real zero(0);
  const std::vector<Index> named = named_face_of_each(mesh);
  std::optional<Index> last;
  for (Index i = 0; i < mesh.faces.size(); ++i) {
    const Point3<Real>&a = mesh.vertices[mesh.faces[i].a], &b = mesh.vertices[mesh.faces[i].b],
          &c = mesh.vertices[mesh.faces[i].c];
    const Vector3<Real> e = b - a, f = c - a, s = ray.origin - a, p = cross(ray.direction, f), q = cross(s, e);
    const Real rise = dot(e, p), ca = dot(s, p), ab = dot(ray.direction, q), bc = Real(Real(rise - ca) - ab);
    const Real height = dot(f, q);
    const auto behind = [&](const Real& value) { return !(rise > zero ? value >= zero : value <= zero); };
    if (rise == zero || behind(ca) || behind(ab) || behind(bc) || behind(height)) continue;
    const Real t = Real(height / rise);
    found.relation = PassageRelation::hit;
    if (last != named[i]) ++found.faces_met;
    last = named[i];
    if (found.first && !(t < found.first->t)) continue;
    const int zeros = (ca == zero) + (ab == zero) + (bc == zero);
    const FacePart part = zeros == 0 ? FacePart::inside : zeros == 1 ? FacePart::edge : FacePart::vertex;
    found.first = FaceHit<Real>{t, ray.origin + t * ray.direction, named[i], part};
  }
  return found;
}

}  // namespace touchstone::reference
