// SPDX-License-Identifier: Apache-2.0
#include "oracle/polyhedra/polyhedron_complexity.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "oracle/exact/rational_validation.h"
#include "oracle/exact/two_faces.h"
#include "oracle/exact/whole_cloud.h"
#include "oracle/polyhedra/point_in_polyhedron.h"

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

/// The places of the faces of each component, in the order of their first ones.
std::vector<std::set<std::size_t>> components(const std::vector<Face>& list, const Surface& surface) {
  std::set<std::size_t> left;
  for (std::size_t i = 0; i < list.size(); ++i) left.insert(i);
  std::vector<std::set<std::size_t>> found;
  while (!left.empty()) {
    found.push_back(reached(*left.begin(), [&](std::size_t face) {
      std::vector<std::size_t> others;
      const Face& f = list[face];
      for (const Index v : {f.a, f.b, f.c}) {
        const auto& faces = surface.at_vertex.at(v);
        others.insert(others.end(), faces.begin(), faces.end());
      }
      return others;
    }));
    for (const std::size_t face : found.back()) left.erase(face);
  }
  return found;
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

using Answer = PolyhedronComplexity<Rational>;

template <class Witness>
void note(std::optional<Witness>& first, const Witness& witness) {
  if (!first) first = witness;
}

/// What the indices tell.
Answer counted(const std::vector<Face>& list, const Surface& surface) {
  Answer found{};
  for (const auto& [edge, faces] : surface.at_edge) {
    const IndexPair ends{*edge.begin(), *edge.rbegin()};
    const auto along = [&](Index from, Index to) {
      return std::count_if(faces.begin(), faces.end(), [&](std::size_t i) { return runs(list[i], from, to); });
    };
    const auto forth = along(ends.i, ends.j), back = along(ends.j, ends.i);
    if (faces.size() % 2 != 0) note(found.open_edge, ends);
    if (forth - back > 1 || back - forth > 1) note(found.turned_edge, ends);
    if (faces.size() > 2) note(found.crowded_edge, ends);
  }
  for (const auto& [vertex, faces] : surface.at_vertex) {
    if (!one_fan(list, surface, vertex)) note(found.pinched_vertex, vertex);
  }
  found.vertices = static_cast<Index>(surface.at_vertex.size()),
  found.edges = static_cast<Index>(surface.at_edge.size());
  found.faces = static_cast<Index>(list.size());
  found.euler = Rational(Rational(found.vertices) - Rational(found.edges) + Rational(found.faces));
  found.closed = !found.open_edge, found.oriented = !found.turned_edge, found.edge_manifold = !found.crowded_edge;
  found.vertex_manifold = found.edge_manifold && !found.pinched_vertex;
  return found;
}

/// The normals of planes between pairs of faces that need one, and the weights of the common point of those that meet.
struct Pairs {
  std::vector<Rational> normals, weights;
};

/// All faces have areas.
Pairs paired(const std::vector<Face>& list, const WholeCloud& cloud, Answer& found) {
  Pairs pairs;
  for (Index i = 0; i < list.size(); ++i) {
    for (Index j = i + 1; j < list.size(); ++j) {
      if (boxes_apart(cloud, list[i], list[j])) continue;
      const TwoFaces two(cloud, list[i], list[j]);
      if (two.meet) {
        found.meeting_faces = IndexPair{i, j};
        pairs.weights.assign(two.on_first.begin(), two.on_first.end());
        pairs.weights.insert(pairs.weights.end(), two.on_second.begin(), two.on_second.end());
        return pairs;
      }
      if (plainly_apart(cloud, list[i], list[j])) continue;
      for (const Integer& n : {two.normal.x, two.normal.y, two.normal.z}) pairs.normals.emplace_back(n);
    }
  }
  return pairs;
}

void look_for_flat_face(const std::vector<Face>& list, const WholeCloud& cloud, Answer& found) {
  for (Index i = 0; i < list.size(); ++i)
    if (zero(cloud.normal(list[i].a, list[i].b, list[i].c))) note(found.flat_face, i);
}

void look_for_splitting_face(const std::vector<Face>& list, const Surface& surface, const WholeCloud& cloud,
                             Answer& found) {
  for (Index i = 0; i < list.size() && !found.splitting_face; ++i) {
    const Face& f = list[i];
    const SupportingPlane plane = cloud.plane(cloud.normal(f.a, f.b, f.c), f.a);
    std::map<int, Index> first;  // by the side
    for (const auto& [vertex, faces] : surface.at_vertex) first.emplace(sgn(cloud.height(plane, vertex)), vertex);
    if (first.contains(1) && first.contains(-1))
      found.splitting_face = SplittingFace{i, std::min(first[1], first[-1]), std::max(first[1], first[-1])};
  }
}

/// Six times the volume: of each face the doubled area seen from above, times the sum of the heights of its corners.
VolumeSign sign_of_volume(const std::vector<Face>& list, const WholeCloud& cloud) {
  Integer sum;
  for (const Face& f : list) sum += cloud.normal(f.a, f.b, f.c).z * (cloud[f.a].z + cloud[f.b].z + cloud[f.c].z);
  return sgn(sum) > 0 ? VolumeSign::positive : sgn(sum) < 0 ? VolumeSign::negative : VolumeSign::zero;
}

/// Of a closed embedded mesh. Returns the directions of the rays, one after the other.
template <class Number>
std::vector<Rational> nest(const Mesh<Number>& mesh, const std::vector<std::set<std::size_t>>& components,
                           const WholeCloud& cloud, Answer& found) {
  std::vector<Rational> directions;
  found.nesting.emplace();
  for (Index i = 0; i < components.size(); ++i) {
    Mesh<Number> outer{mesh.vertices, {}};
    std::set<Index> corners;
    for (const std::size_t face : components[i]) {
      const Face& f = mesh.faces[face];
      outer.faces.push_back(f), corners.insert({f.a, f.b, f.c});
    }
    const auto in_box = [&](Index vertex) {
      for (Integer Point3<Integer>::*axis : {&Point3<Integer>::x, &Point3<Integer>::y, &Point3<Integer>::z}) {
        const auto below = [&](Index one, Index other) { return cloud[one].*axis < cloud[other].*axis; };
        const auto [least, greatest] = std::minmax_element(corners.begin(), corners.end(), below);
        if (below(vertex, *least) || below(*greatest, vertex)) return false;
      }
      return true;
    };
    for (Index j = 0; j < components.size(); ++j) {
      const Index inner = mesh.faces[*components[j].begin()].a;
      if (i == j || !in_box(inner)) continue;
      const Truth<Location> where = point_in_polyhedron(outer, mesh.vertices[inner]);
      if (where.answer == Location::inside) found.nesting->push_back({i, j});
      for (const auto& [name, values] : where.certificate().facts)
        if (name == "direction") directions.insert(directions.end(), values.begin(), values.end());
    }
  }
  return directions;
}

template <class Number>
Truth<Answer> truth_of(const Mesh<Number>& mesh) {
  validation::validate("mesh", mesh), validation::validate_triangles("mesh", mesh);
  Surface surface;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const Face& f = mesh.faces[i];
    for (const Index v : {f.a, f.b, f.c}) surface.at_vertex[v].push_back(i);
    for (const Edge& edge : edges_of(f)) surface.at_edge[edge].push_back(i);
  }
  Answer found = counted(mesh.faces, surface);
  const auto parts = components(mesh.faces, surface);
  found.components = static_cast<Index>(parts.size());
  const WholeCloud cloud(mesh.vertices);
  if (found.closed && found.oriented) found.volume = sign_of_volume(mesh.faces, cloud);
  look_for_flat_face(mesh.faces, cloud, found);
  Pairs pairs;
  if (!found.flat_face) pairs = paired(mesh.faces, cloud, found);
  found.embedded = !found.flat_face && !found.meeting_faces;
  std::vector<Rational> directions;
  if (found.closed && found.embedded) {
    look_for_splitting_face(mesh.faces, surface, cloud, found);
    found.convex = !found.splitting_face;
    directions = nest(mesh, parts, cloud, found);
  }
  return {found, std::nullopt, [pairs = std::move(pairs), directions = std::move(directions)] {
            return Certificate{
                "complexity",
                {{"normals", pairs.normals}, {"common_point", pairs.weights}, {"directions", directions}}};
          }};
}

}  // namespace

Truth<Answer> polyhedron_complexity(const Meshd& mesh) { return truth_of(mesh); }

template <Exact Number>
Truth<PolyhedronComplexity<Rational>> polyhedron_complexity(const Mesh<Number>& mesh) {
  return truth_of(mesh);
}
template Truth<PolyhedronComplexity<Rational>> polyhedron_complexity(const Mesh<Rational>&);

}  // namespace touchstone::oracle
