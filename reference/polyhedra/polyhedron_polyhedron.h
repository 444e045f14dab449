// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/polyhedra.h"
#include "geometry/solids.h"
#include "reference/polyhedra/point_in_polyhedron.h"
#include "reference/polyhedra/segment_triangle.h"

namespace touchstone::reference {

/// The relation of the solids within two closed meshes, convex or not, and which step of the test decides.
///
/// Deck p. 25, 52-54: first bounding volumes; then is a vertex of one inside the other; then the edges of one against
/// the faces of the other. Here the bounding volumes are the boxes along the axes around the vertices that faces name;
/// inside is decided by the ray of reference/polyhedra/point_in_polyhedron.h; an edge meets a face as in
/// reference/polyhedra/segment_triangle.h.
///
/// a, b: any unit of length, the same for both. Both are closed as there: every edge is in an even number of faces, and
/// that is all. The solid is all points with an odd number of faces between them and infinity, together with all faces;
/// its interior is the first of the two without the faces, open. relation: `disjoint`, no common point; `overlapping`,
/// a common point of the interiors; `touching`, only others. Faces that separate nothing (there twice, or without area)
/// may touch the other solid, within it too, and do not overlap it.
///
/// decided_by: `bounding_volumes` where the boxes, closed, have no common point. Otherwise `vertex_inside` where a
/// vertex that a face names lies in the interior of the other solid, not on its faces. Otherwise `edge_against_face`.
///
/// Degenerate: refused by robust and oracle with field and rule, the first that applies: NaN or infinity in a
/// (a.vertices[i][c], "finite number"), then in b; then for a, then for b: a face that names no vertex (a.faces[i][k],
/// "index of a vertex"), or one twice (a.faces[i], "three different vertices"); fewer than 4 faces (a, "at least 4
/// faces"); an edge in an odd number of faces (a.faces[i], "closed: the edge ...").
///
/// The slides only ask whether two polyhedra collide. Here a vertex inside is `overlapping`; so is an edge that meets a
/// face between its ends, and `touching` is one that ends in it. In exact arithmetic that is right where no vertex is
/// on a face's plane, no edge meets an edge and no face separates nothing. Where solids share a plane, an edge or a
/// vertex it may be wrong (cause: algorithm): equal solids have no vertex inside and no edge through a face.
///
/// Margin, a squared length: `bounding_volumes`, the square of the greatest gap of the boxes along an axis. `disjoint`
/// by `edge_against_face`: the least squared distance of a face of one from a face of the other, or the square of the
/// least length that the boxes have in common along an axis, if that is less. `overlapping`: of a vertex that is inside
/// the squared distance from the other's faces, the greatest of all; without such a vertex, the least squared distance
/// of a vertex that a face names from the other's faces. `touching`: 0.
///
/// Rounding (binary64, to nearest): boxes are compared, so the double version is right with `bounding_volumes`. For the
/// rest the bounds of reference/polyhedra/point_in_polyhedron.h and segment_triangle.h hold.
template <class Real>
PolyhedronPolyhedron polyhedron_polyhedron(const Mesh<Real>& a, const Mesh<Real>& b) {
  const auto apart = [&a, &b](Real Point3<Real>::*axis) {
    const auto range = [axis](const Mesh<Real>& mesh) {
      Real low = mesh.vertices[mesh.faces[0].a].*axis, high = low;
      for (const Face& face : mesh.faces) {
        for (const Index i : {face.a, face.b, face.c})
          low = std::min(low, mesh.vertices[i].*axis), high = std::max(high, mesh.vertices[i].*axis);
      }
      return std::pair{low, high};
    };
    const auto [low_a, high_a] = range(a);
    const auto [low_b, high_b] = range(b);
    return high_a < low_b || high_b < low_a;
  };
  if (apart(&Point3<Real>::x) || apart(&Point3<Real>::y) || apart(&Point3<Real>::z))
    return {Contact::disjoint, PolyhedraStep::bounding_volumes};

  const auto any_inside = [](const Mesh<Real>& mesh, const Mesh<Real>& other) {
    std::vector<bool> asked(mesh.vertices.size());
    return std::any_of(mesh.faces.begin(), mesh.faces.end(), [&](const Face& face) {
      const auto inside = [&](Index i) {
        if (asked[i]) return false;
        asked[i] = true;
        return point_in_polyhedron(other, mesh.vertices[i]) == Location::inside;
      };
      return inside(face.a) || inside(face.b) || inside(face.c);
    });
  };
  if (any_inside(a, b) || any_inside(b, a)) return {Contact::overlapping, PolyhedraStep::vertex_inside};

  bool met = false, through = false;
  const auto edges_against_faces = [&met, &through](const Mesh<Real>& mesh, const Mesh<Real>& other) {
    for (const Face& e : mesh.faces) {
      for (const auto& [from, to] : {std::pair{e.a, e.b}, {e.b, e.c}, {e.c, e.a}}) {
        const Segment3<Real> edge{mesh.vertices[from], mesh.vertices[to]};
        for (const Face& f : other.faces) {
          const Triangle3<Real> face{other.vertices[f.a], other.vertices[f.b], other.vertices[f.c]};
          const SegmentTriangle<Real> meeting = segment_triangle(edge, face);
          if (meeting.relation == SegmentTriangleRelation::none) continue;
          met = true;
          through = through || (*meeting.t > Real(0) && *meeting.t < Real(1));
        }
      }
    }
  };
  edges_against_faces(a, b), edges_against_faces(b, a);
  return {through ? Contact::overlapping
          : met   ? Contact::touching
                  : Contact::disjoint,
          PolyhedraStep::edge_against_face};
}

}  // namespace touchstone::reference
