// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/complexity.h"
#include "geometry/polyhedra.h"
#include "reference/polyhedra/point_in_polyhedron.h"
#include "reference/polyhedra/triangle_triangle.h"

namespace touchstone::reference {

/// The numbers of vertices, edges and faces of a mesh; whether it is a surface, and of which kind; the solid it
/// encloses.
///
/// Deck p. 26: V vertices, E edges, F faces, and Euler's formula
///     V - E + F = 2
/// of a polyhedron without holes. Every face of the list counts; an edge is a pair of vertices, in whichever
/// order, that follow each other in some face; a vertex counts if some face names it. Vertices are identified by their
/// indices: vertices at one position are several. A face that is named by a polygon is one face, however it is cut
/// (geometry/polyhedra.h): its diagonals are no edges, and all places are those of the faces as named.
///
/// euler: V - E + F, 2 a component less 2 a handle for surfaces without a rim. components: faces that share a vertex
/// are of one. closed: every edge is in an even number of faces, so that parity tells inside from outside
/// (point_in_polyhedron.h). oriented: of the faces at an edge, as many run along it in one direction as in the other,
/// one more at most. edge_manifold: every edge is in one face or two. vertex_manifold: every edge is, and the faces at
/// a vertex, each a neighbour of the next by an edge at that vertex, are one fan or one ring; two sheets that meet in a
/// vertex alone are none, which counting V - E + F does not see, nor does looking at edges.
///
/// embedded: every face has an area, and no two faces have a point in common but corners that both name and the edges
/// that both have. Faces of the same three vertices coincide; an edge of one along a diagonal of the other is contact.
/// So a flat part cut into triangles is embedded, a face folded back on its neighbour is not, nor is a corner that
/// touches another face or stands in one position with a vertex of another number: vertices that a file repeats have to
/// be merged first. convex: the mesh is closed and embedded, and no face's plane has vertices on both sides. Then the
/// faces are the entire surface of a convex solid, each part of it once: every face lies in a facet of the convex hull,
/// and across no edge does the number of faces that lie there, 0 or 1, change. Faces may turn either way, several may
/// lie in one plane, and edges and vertices may be flat. volume: the sign of the sum of a . (b x c) over all faces, six
/// times the volume, of which each part counts as often as the mesh goes around it; positive where faces are
/// counter-clockwise from outside. `none` unless the mesh is closed and oriented: otherwise the sum depends on where
/// the origin is.
///
/// nesting: which component contains which, of a closed and embedded mesh, and omitted for others. Its components have
/// no common point, so that each lies inside another or outside it (by point_in_polyhedron.h). All pairs, containing
/// component first, in ascending order; components are numbered in the order of their first faces.
///
/// A word that is false has a witness, the first. For edges (lesser vertex first) and vertices, in ascending order:
/// open_edge (not closed), turned_edge (not oriented), crowded_edge (no edge_manifold), pinched_vertex, whose faces are
/// several fans or rings. For embedded: flat_face, the first without area; if there is none, meeting_faces, the first
/// pair in ascending order, lesser face first. For convex: those of closed and embedded, and if both hold,
/// splitting_face: the first face whose plane has vertices on both sides, the first vertex that is off the plane, and
/// the first on its other side.
///
/// The formula takes a mesh for vertex_manifold if it is edge_manifold, and looks only at pairs of faces without a
/// common vertex, each pair by p. 54's edges against the other face (triangle_triangle.h), which sees no contact within
/// one plane (cause: algorithm). Planes are p. 53's sides of faces, and nesting is its ray, of one vertex each, which
/// may run through an edge (cause: algorithm). Rounding: none in what is counted. Where coordinates are integers below
/// 2^15 the sides of faces are exact, and so is convex of an embedded mesh; nothing else is promised of doubles.
///
/// Degenerate: NaN or infinity (mesh.vertices[i][c], "finite number"), a face that names no vertex (mesh.faces[i][k],
/// "index of a vertex") or one twice (mesh.faces[i], "three different vertices"), fewer than 4 faces (mesh, "at least 4
/// faces"): refused by robust and oracle.
template <class Real>
PolyhedronComplexity<Real> polyhedron_complexity(const Mesh<Real>& mesh) {
  using Edge = std::pair<Index, Index>;
  std::map<Edge, Edge> edges;  // number of faces that run along it in each direction
  std::map<Index, Index> parts;
  for (std::size_t i = 0; i < named_faces(mesh); ++i) {
    const std::vector<Index> corners = corners_of_named(mesh, i);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Index from = corners[k], to = corners[(k + 1) % corners.size()];
      auto& [forth, back] = edges[std::minmax(from, to)];
      ++(from < to ? forth : back);
      parts.emplace(from, from);
    }
  }
  for (bool merged = true; merged;) {  // the least vertex of a part spreads
    merged = false;
    for (const auto& [edge, count] : edges) {
      Index &p = parts[edge.first], &q = parts[edge.second];
      if (p == q) continue;
      p = q = std::min(p, q), merged = true;
    }
  }
  std::vector<Mesh<Real>> components;
  std::map<Index, std::size_t> numbers;
  for (const Face& f : mesh.faces) {
    const auto [number, added] = numbers.emplace(parts[f.a], components.size());
    if (added) components.push_back({mesh.vertices, {}});
    components[number->second].faces.push_back(f);
  }
  const auto first_edge = [&edges](const auto& defective) -> std::optional<IndexPair> {
    for (const auto& [edge, uses] : edges)
      if (defective(uses.first, uses.second)) return IndexPair{edge.first, edge.second};
    return std::nullopt;
  };
  const auto v = static_cast<Index>(parts.size()), e = static_cast<Index>(edges.size()),
             n = static_cast<Index>(named_faces(mesh)), f = static_cast<Index>(mesh.faces.size());
  PolyhedronComplexity<Real> found{};
  found.vertices = v, found.edges = e, found.faces = n, found.components = static_cast<Index>(components.size());
  found.euler = Real(static_cast<int>(v) - static_cast<int>(e) + static_cast<int>(n));
  found.open_edge = first_edge([](Index forth, Index back) { return (forth + back) % 2 != 0; });
  found.turned_edge = first_edge([](Index forth, Index back) { return forth > back + 1 || back > forth + 1; });
  found.crowded_edge = first_edge([](Index forth, Index back) { return forth + back > 2; });

  const std::vector<Index> named = named_face_of_each(mesh);
  const auto triangle = [&mesh](Index face) {
    const Face& corners = mesh.faces[face];
    return Triangle3<Real>{mesh.vertices[corners.a], mesh.vertices[corners.b], mesh.vertices[corners.c]};
  };
  const auto normal = [](const Triangle3<Real>& t) { return cross(t.b - t.a, t.c - t.a); };
  for (Index i = 0; i < f && !found.flat_face; ++i) {
    const Vector3<Real> n = normal(triangle(i));
    if (n.x == Real(0) && n.y == Real(0) && n.z == Real(0)) found.flat_face = named[i];
  }
  const auto apart = [&mesh](const Face& s, const Face& t) {
    const auto has = [&t](Index corner) { return corner == t.a || corner == t.b || corner == t.c; };
    return !has(s.a) && !has(s.b) && !has(s.c);
  };
  std::optional<IndexPair>& meeting = found.meeting_faces;
  for (Index i = 0; i < f && !found.flat_face && !(meeting && meeting->i != named[i]); ++i) {
    for (Index j = i + 1; j < f && !(meeting && meeting->j <= named[j]); ++j) {
      if (named[i] == named[j] || !apart(mesh.faces[i], mesh.faces[j])) continue;
      if (triangle_triangle(triangle(i), triangle(j)) != TriangleTriangleRelation::none)
        meeting = IndexPair{named[i], named[j]};
    }
  }
  const bool solid = !found.open_edge && !found.flat_face && !found.meeting_faces;
  for (Index i = 0; i < f && solid && !found.splitting_face; ++i) {
    const Triangle3<Real> face = triangle(i);
    std::optional<Index> front, back;
    for (const auto& [vertex, part] : parts) {
      const Real side = dot(normal(face), mesh.vertices[vertex] - face.a);
      if (side > Real(0) && !front) front = vertex;
      if (side < Real(0) && !back) back = vertex;
    }
    if (front && back) found.splitting_face = SplittingFace{named[i], std::min(*front, *back), std::max(*front, *back)};
  }
  if (!found.open_edge && !found.turned_edge) {
    Real sum(0);
    const Point3<Real> origin{Real(0), Real(0), Real(0)};
    for (Index i = 0; i < f; ++i) {
      const auto [a, b, c] = triangle(i);
      sum = sum + dot(a - origin, cross(b - origin, c - origin));
    }
    found.volume = sum > Real(0) ? VolumeSign::positive : sum < Real(0) ? VolumeSign::negative : VolumeSign::zero;
  }
  if (solid) {
    found.nesting.emplace();
    for (Index i = 0; i < components.size(); ++i) {
      for (Index j = 0; j < components.size(); ++j) {
        const Point3<Real>& inner = mesh.vertices[components[j].faces[0].a];
        if (i != j && point_in_polyhedron(components[i], inner) == Location::inside) found.nesting->push_back({i, j});
      }
    }
  }
  found.closed = !found.open_edge, found.oriented = !found.turned_edge;
  found.edge_manifold = found.vertex_manifold = !found.crowded_edge;
  found.embedded = !found.flat_face && !found.meeting_faces, found.convex = solid && !found.splitting_face;
  return found;
}

}  // namespace touchstone::reference
