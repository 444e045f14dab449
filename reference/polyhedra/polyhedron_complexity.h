// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "geometry/complexity.h"
#include "geometry/polyhedra.h"

namespace touchstone::reference {

/// How many vertices, edges and faces a mesh has, and whether it is a surface, by counting.
///
/// Deck p. 26: V vertices, E edges, F faces, and Euler's formula V - E + F = 2 of a polyhedron without holes. Of faces,
/// every one of the list counts; an edge is a pair of vertices, in whichever order, that some face has; a vertex counts
/// if some face names it. Positions are not looked at: vertices in one position are several.
///
/// euler: V - E + F, 2 a component less 2 a handle for surfaces without a rim. components: faces that share a vertex
/// are of one. closed: every edge is in an even number of faces, so that parity tells inside from outside
/// (point_in_polyhedron.h). oriented: of the faces at an edge, as many run along it one way as the other, one more at
/// most. edge_manifold: every edge is in one face or two. vertex_manifold: every edge is, and the faces at a vertex,
/// each a neighbour of the next by an edge at that vertex, are one fan or one ring; two sheets that meet in a vertex
/// alone are none, which counting V - E + F does not see, nor does looking at edges.
///
/// The formula here takes a mesh for vertex_manifold if it is edge_manifold. Degenerate: NaN or infinity
/// (mesh.vertices[i][c], "finite number"), a face that names no vertex (mesh.faces[i][k], "index of a vertex") or one
/// twice (mesh.faces[i], "three different vertices"), fewer than 4 faces (mesh, "at least 4 faces"): refused by robust
/// and oracle.
template <class Real>
PolyhedronComplexity<Real> polyhedron_complexity(const Mesh<Real>& mesh) {
  std::map<std::pair<Index, Index>, std::pair<Index, Index>> edges;  // how many faces run along it each way
  std::map<Index, Index> parts;
  for (const Face& f : mesh.faces) {
    for (const auto& [from, to] : {std::pair{f.a, f.b}, {f.b, f.c}, {f.c, f.a}}) {
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
  std::set<Index> least;
  for (const auto& [vertex, part] : parts) least.insert(part);
  const auto all = [&edges](const auto& holds) {
    return std::all_of(edges.begin(), edges.end(),
                       [&](const auto& edge) { return holds(edge.second.first, edge.second.second); });
  };
  const auto v = static_cast<Index>(parts.size()), e = static_cast<Index>(edges.size()),
             f = static_cast<Index>(mesh.faces.size());
  const bool manifold = all([](Index forth, Index back) { return forth + back <= 2; });
  return {.vertices = v,
          .edges = e,
          .faces = f,
          .components = static_cast<Index>(least.size()),
          .euler = Real(static_cast<int>(v) - static_cast<int>(e) + static_cast<int>(f)),
          .closed = all([](Index forth, Index back) { return (forth + back) % 2 == 0; }),
          .oriented = all([](Index forth, Index back) { return forth <= back + 1 && back <= forth + 1; }),
          .edge_manifold = manifold,
          .vertex_manifold = manifold};
}

}  // namespace touchstone::reference
