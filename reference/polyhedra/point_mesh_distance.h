// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "geometry/point_mesh_distance.h"
#include "geometry/triangles.h"
#include "reference/polyhedra/point_in_polyhedron.h"

namespace touchstone::reference {

/// The fraction of a total that a number is.
struct ByQuotient {
  template <class Real>
  static std::array<Real, 2> parts(const Real& x, const Real& y, const Real& total) {
    return {Real(x / total), Real(y / total)};
  }
};

/// A point of a triangle, and where in the triangle it is.
template <class Real>
struct PlaceInTriangle {
  Point3<Real> point;
  FacePart part;
};

/// Selects the region in which p lies: of a corner, of an edge, or of the face.
template <class Real, class Division = ByQuotient>
PlaceInTriangle<Real> nearest_place_in_triangle(const Point3<Real>& p, const Triangle3<Real>& triangle) {
  const auto& [a, b, c] = triangle;
  const Vector3<Real> ab = b - a, ac = c - a;
  const Real zero(0), from_a = dot(ab, p - a), on_ac = dot(ac, p - a);
  if (from_a <= zero && on_ac <= zero) return {a, FacePart::vertex};
  const Real from_b = dot(ab, p - b), on_ac_of_b = dot(ac, p - b);
  if (from_b >= zero && on_ac_of_b <= from_b) return {b, FacePart::vertex};
  const Real of_c = Real(from_a * on_ac_of_b - from_b * on_ac);
  if (of_c <= zero && from_a >= zero && from_b <= zero)
    return {a + Real(from_a / Real(from_a - from_b)) * ab, FacePart::edge};
  const Real from_c = dot(ab, p - c), on_ac_of_c = dot(ac, p - c);
  if (on_ac_of_c >= zero && from_c <= on_ac_of_c) return {c, FacePart::vertex};
  const Real of_b = Real(from_c * on_ac - from_a * on_ac_of_c);
  if (of_b <= zero && on_ac >= zero && on_ac_of_c <= zero)
    return {a + Real(on_ac / Real(on_ac - on_ac_of_c)) * ac, FacePart::edge};
  const Real of_a = Real(from_b * on_ac_of_c - from_c * on_ac_of_b);
  const Real leaves_b = Real(on_ac_of_b - from_b), leaves_c = Real(from_c - on_ac_of_c);
  if (of_a <= zero && leaves_b >= zero && leaves_c >= zero)
    return {b + Real(leaves_b / Real(leaves_b + leaves_c)) * (c - b), FacePart::edge};
  const auto [to_b, to_c] = Division::parts(of_b, of_c, Real(of_a + of_b + of_c));
  return {a + (to_b * ab + to_c * ac), FacePart::inside};
}

/// The point of the surface of a solid that is nearest to a point, its distance and the square of that, the distance
/// with a sign, and the face, edge or vertex that the nearest point is on.
///
/// No page of the deck asks this. The formula is what programs use: the nearest point of each face (Ericson, Real-Time
/// Collision Detection, 5.1.5, as in closest_point_on_triangle.h), of which the first with the least square is kept;
/// the part is the region that named the point. The sign is by parity, the ray test of point_in_polyhedron.h, as in
/// Open3D's RaycastingScene::ComputeSignedDistance and trimesh's contains; libigl's usual sign, by angle-weighted
/// normals (Baerentzen and Aanaes, Signed distance computation using the angle weighted pseudonormal, 2005), asks more
/// of a mesh than this contract does: faces that all turn the same way, and none that cross.
///
/// point, mesh: any unit of length, the same for both; the squared distance is in its square. The mesh is what
/// point_in_polyhedron takes: closed, every edge in an even number of faces; its surface is the union of all of its
/// faces, also of those that separate nothing or have no area. `location` is that of point_in_polyhedron, `boundary`
/// exactly where the distance is 0. signed_distance is the distance outside, its negative inside, and 0 on the
/// boundary. Several points of the surface may be as near: `point` is the first of them in lexicographic order, by x,
/// then y, then z, so it is the same however faces are listed, turned or cut. `face` is the least index of the faces
/// that have the point, as the mesh names them. `part` is `vertex` where the point is a corner of that face, else
/// `edge` where it is on an edge of it, between two corners that the face names one after the other, and otherwise
/// `inside`; a face without area has no inside. Engines may name another point that is as near, unless they declare
/// that they name this one (`nearest`, docs/engines.md).
///
/// Degenerate: refused by robust and oracle with field and rule, the first that applies: NaN or infinity in the point
/// (point[c], "finite number"), or in the mesh (mesh.vertices[i][c], "finite number"); and then what
/// point_in_polyhedron refuses, in the same words: a face that names no vertex (mesh.faces[i][k], "index of a vertex"),
/// or one twice (mesh.faces[i], "three different vertices"); fewer than 4 faces (mesh, "at least 4 faces"); an edge in
/// an odd number of faces (mesh.faces[i], "closed: the edge ..."). Faces of more than three corners are cut first, and
/// refused by the rules of docs/meshes.md before everything else.
///
/// A number of the answer beyond the range of doubles is infinite.
///
/// In exact arithmetic the distance is right if no face has its first two corners in one position. The formula names
/// that of several nearest points which the first face has; it takes a diagonal of the cut of a face for an edge, and
/// passes over a corner within an edge; and the sign is wrong where the ray meets an edge (cause: algorithm).
///
/// Margin: the squared distance of the point from the surface, at which the location changes; which point, face and
/// part are named is not counted.
///
/// Rounding (binary64, to nearest, u = 2^-53), where the part as computed is `edge` or `vertex` and all numbers are
/// finite: the point is on each axis within 4u (W + M) + 2^-1073 of a point of its face, W being the extent of that
/// and M its greatest magnitude on the axis. For a quotient of numbers that are not negative by their sum is at most 1;
/// the edge's displacement is off by u W, its multiple by u W more, and the sum by u times itself. Let e be the sum of
/// these over the axes; then the distance D is not too short by more: D >= (D* - e) (1 - 4u) - 2^-536, D* being the
/// exact one. Nothing is promised of other points, nor of a sign. ulps: 66 roundings behind the distance, as in
/// closest_point_on_triangle.h.
template <class Real>
PointMeshDistance<Real> point_mesh_distance(const Point3<Real>& point, const Mesh<Real>& mesh) {
  using std::sqrt;
  const std::vector<Index> named = named_face_of_each(mesh);
  std::optional<PointMeshDistance<Real>> nearest;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const auto& [a, b, c] = mesh.faces[i];
    const auto [x, part] =
        nearest_place_in_triangle<Real>(point, {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    const Real square = dot(point - x, point - x);
    if (nearest && !(square < nearest->squared_distance)) continue;
    const Real distance = Real(sqrt(square));
    nearest = {Location::boundary, {x, named[i], part}, square, distance, distance};
  }
  if (nearest->distance == Real(0)) return *nearest;
  nearest->location = point_in_polyhedron(mesh, point);
  if (nearest->location == Location::inside) nearest->signed_distance = Real(-nearest->distance);
  return *nearest;
}

}  // namespace touchstone::reference
