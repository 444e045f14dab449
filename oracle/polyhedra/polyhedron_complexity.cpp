// SPDX-License-Identifier: Apache-2.0
#include "oracle/polyhedra/polyhedron_complexity.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "oracle/exact/rational_validation.h"

namespace touchstone::oracle {
namespace {

using Edge = std::set<Index>;

/// Whether all elements are reached from the first, each step leading from one to its neighbours.
template <class Element, class Neighbours>
std::set<Element> reached(const Element& first, const Neighbours& neighbours) {
  std::set<Element> seen{first};
  std::vector<Element> left{first};
  while (!left.empty()) {
    const Element at = left.back();
    left.pop_back();
    for (const Element& other : neighbours(at)) {
      if (seen.insert(other).second) left.push_back(other);
    }
  }
  return seen;
}

struct Surface {
  std::map<Index, std::vector<std::size_t>> at_vertex;
  std::map<Edge, std::vector<std::size_t>> at_edge;
};

std::array<Edge, 3> edges_of(const Face& f) { return {Edge{f.a, f.b}, Edge{f.b, f.c}, Edge{f.c, f.a}}; }

bool runs(const Face& f, Index from, Index to) {
  return (f.a == from && f.b == to) || (f.b == from && f.c == to) || (f.c == from && f.a == to);
}

Index components(const std::vector<Face>& list, const Surface& surface) {
  std::set<std::size_t> left;
  for (std::size_t i = 0; i < list.size(); ++i) left.insert(i);
  Index count = 0;
  for (; !left.empty(); ++count) {
    const auto part = reached(*left.begin(), [&](std::size_t face) {
      std::vector<std::size_t> others;
      const Face& f = list[face];
      for (const Index v : {f.a, f.b, f.c}) {
        const auto& faces = surface.at_vertex.at(v);
        others.insert(others.end(), faces.begin(), faces.end());
      }
      return others;
    });
    for (const std::size_t face : part) left.erase(face);
  }
  return count;
}

/// The faces at the vertex are neighbours of neighbours of one of them, by edges that end there.
bool one_fan(const std::vector<Face>& list, const Surface& surface, Index vertex) {
  const auto& faces = surface.at_vertex.at(vertex);
  return reached(faces.front(), [&](std::size_t face) {
           std::vector<std::size_t> others;
           for (const Edge& edge : edges_of(list[face])) {
             if (!edge.contains(vertex)) continue;
             const auto& there = surface.at_edge.at(edge);
             others.insert(others.end(), there.begin(), there.end());
           }
           return others;
         }).size() == faces.size();
}

/// What the surface is not, at the first place where it is not.
struct Defects {
  std::vector<Rational> open, turned, crowded, pinched;
};

void note(std::vector<Rational>& defect, const Edge& at) {
  if (defect.empty()) defect.assign(at.begin(), at.end());
}

template <class Number>
Truth<PolyhedronComplexity<Rational>> truth_of(const Mesh<Number>& mesh) {
  validation::validate("mesh", mesh), validation::validate_triangles("mesh", mesh);
  Surface surface;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const Face& f = mesh.faces[i];
    for (const Index v : {f.a, f.b, f.c}) surface.at_vertex[v].push_back(i);
    for (const Edge& edge : edges_of(f)) surface.at_edge[edge].push_back(i);
  }
  Defects found;
  for (const auto& [edge, faces] : surface.at_edge) {
    const auto along = [&](Index from, Index to) {
      return std::count_if(faces.begin(), faces.end(), [&](std::size_t i) { return runs(mesh.faces[i], from, to); });
    };
    const auto forth = along(*edge.begin(), *edge.rbegin()), back = along(*edge.rbegin(), *edge.begin());
    if (faces.size() % 2 != 0) note(found.open, edge);
    if (forth - back > 1 || back - forth > 1) note(found.turned, edge);
    if (faces.size() > 2) note(found.crowded, edge);
  }
  for (const auto& [vertex, faces] : surface.at_vertex) {
    if (!one_fan(mesh.faces, surface, vertex)) note(found.pinched, {vertex});
  }
  const auto vertices = static_cast<Index>(surface.at_vertex.size()),
             edges = static_cast<Index>(surface.at_edge.size()), faces = static_cast<Index>(mesh.faces.size());
  const bool manifold = found.crowded.empty();
  return {{.vertices = vertices,
           .edges = edges,
           .faces = faces,
           .components = components(mesh.faces, surface),
           .euler = Rational(Rational(vertices) - Rational(edges) + Rational(faces)),
           .closed = found.open.empty(),
           .oriented = found.turned.empty(),
           .edge_manifold = manifold,
           .vertex_manifold = manifold && found.pinched.empty()},
          std::nullopt,
          [found] {
            return Certificate{"complexity",
                               {{"open_edge", found.open},
                                {"turned_edge", found.turned},
                                {"crowded_edge", found.crowded},
                                {"pinched_vertex", found.pinched}}};
          }};
}

}  // namespace

Truth<PolyhedronComplexity<Rational>> polyhedron_complexity(const Meshd& mesh) { return truth_of(mesh); }

template <Exact Number>
Truth<PolyhedronComplexity<Rational>> polyhedron_complexity(const Mesh<Number>& mesh) {
  return truth_of(mesh);
}
template Truth<PolyhedronComplexity<Rational>> polyhedron_complexity(const Mesh<Rational>&);

}  // namespace touchstone::oracle
