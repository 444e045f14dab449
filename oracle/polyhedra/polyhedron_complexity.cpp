// SPDX-License-Identifier: Apache-2.0
#include "oracle/polyhedra/polyhedron_complexity.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "geometry/validation.h"
#include "oracle/exact/shapes/point_tree.h"
#include "oracle/exact/shapes/whole_cloud.h"
#include "oracle/exact/solids/near_triangles.h"
#include "oracle/exact/solids/polygon_faces.h"
#include "oracle/exact/solids/solid.h"
#include "oracle/exact/solids/two_faces.h"

namespace touchstone::oracle {
namespace {

using Edge = std::set<Index>;

/// True if all elements are reached from the first, each step leading from one to its neighbours.
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

/// The corners of a face in order, as it is named.
using Corners = std::vector<Index>;

/// A corner of a face, and its surroundings.
struct Corner {
  std::size_t face;
  Index before, vertex, after;
};

struct Surface {
  template <class Number>
  explicit Surface(const Mesh<Number>& mesh) {
    for (std::size_t i = 0; i < named_faces(mesh); ++i) {
      const Corners& corners = faces.emplace_back(corners_of_named(mesh, i));
      const std::size_t count = corners.size();
      for (std::size_t k = 0; k < count; ++k) {
        const Corner corner{i, corners[(k + count - 1) % count], corners[k], corners[(k + 1) % count]};
        at_vertex[corner.vertex].push_back(all.size());
        at_edge[{corner.vertex, corner.after}].push_back(all.size());
        all.push_back(corner);
      }
    }
  }
  /// True if the corners, at one vertex, are ends of one edge.
  bool share_an_edge(std::size_t one, std::size_t other) const {
    const Corner &c = all[one], &d = all[other];
    return c.before == d.before || c.before == d.after || c.after == d.before || c.after == d.after;
  }
  bool has_edge(std::size_t face, Index from, Index to) const {
    const auto users = at_edge.find(Edge{from, to});
    return users != at_edge.end() && std::any_of(users->second.begin(), users->second.end(),
                                                 [&](std::size_t corner) { return all[corner].face == face; });
  }

  std::vector<Corners> faces;
  std::vector<Corner> all;
  std::map<Index, std::vector<std::size_t>> at_vertex;  // corners
  std::map<Edge, std::vector<std::size_t>> at_edge;     // corners from which it is run along
};

/// The indices of the faces of each component, in the order of their first ones.
std::vector<std::set<std::size_t>> components(const Surface& surface) {
  std::set<std::size_t> left;
  for (std::size_t i = 0; i < surface.faces.size(); ++i) left.insert(i);
  std::vector<std::set<std::size_t>> found;
  while (!left.empty()) {
    found.push_back(reached(*left.begin(), [&](std::size_t face) {
      std::vector<std::size_t> others;
      for (const Index v : surface.faces[face])
        for (const std::size_t corner : surface.at_vertex.at(v)) others.push_back(surface.all[corner].face);
      return others;
    }));
    for (const std::size_t face : found.back()) left.erase(face);
  }
  return found;
}

/// True if all corners at the vertex are reached from one of them, by edges that end there.
bool one_fan(const Surface& surface, Index vertex) {
  const auto& corners = surface.at_vertex.at(vertex);
  return reached(corners.front(), [&](std::size_t corner) {
           std::vector<std::size_t> others;
           std::copy_if(corners.begin(), corners.end(), std::back_inserter(others),
                        [&](std::size_t other) { return surface.share_an_edge(corner, other); });
           return others;
         }).size() == corners.size();
}

using PolyhedronComplexityAnswer = PolyhedronComplexity<Rational>;

template <class Witness>
void note(std::optional<Witness>& first, const Witness& witness) {
  if (!first) first = witness;
}

/// The properties that follow from the indices.
PolyhedronComplexityAnswer counted(const Surface& surface) {
  PolyhedronComplexityAnswer found{};
  for (const auto& [edge, users] : surface.at_edge) {
    const IndexPair ends{*edge.begin(), *edge.rbegin()};
    const auto forth = std::count_if(users.begin(), users.end(),
                                     [&](std::size_t corner) { return surface.all[corner].vertex == ends.i; });
    const auto back = static_cast<std::ptrdiff_t>(users.size()) - forth;
    if (users.size() % 2 != 0) note(found.open_edge, ends);
    if (forth - back > 1 || back - forth > 1) note(found.turned_edge, ends);
    if (users.size() > 2) note(found.crowded_edge, ends);
  }
  for (const auto& [vertex, corners] : surface.at_vertex) {
    if (!one_fan(surface, vertex)) note(found.pinched_vertex, vertex);
  }
  found.vertices = static_cast<Index>(surface.at_vertex.size()),
  found.edges = static_cast<Index>(surface.at_edge.size());
  found.faces = static_cast<Index>(surface.faces.size());
  found.euler = Rational(Rational(found.vertices) - Rational(found.edges) + Rational(found.faces));
  found.closed = !found.open_edge, found.oriented = !found.turned_edge, found.edge_manifold = !found.crowded_edge;
  found.vertex_manifold = found.edge_manifold && !found.pinched_vertex;
  return found;
}

/// The triangles of each face as it is named.
using Cuts = std::vector<std::vector<Index>>;

template <class Number>
Cuts cuts_of(const Mesh<Number>& mesh) {
  Cuts cuts(named_faces(mesh));
  const std::vector<Index> named = named_face_of_each(mesh);
  for (Index i = 0; i < mesh.faces.size(); ++i) cuts[named[i]].push_back(i);
  return cuts;
}

/// The normals of planes between pairs of triangles that need one; for the pair that meets the weights of a common
/// point, and its indices.
struct Pairs {
  std::vector<Rational> normals, weights, triangles;
};

/// The middle of two vertices that both triangles use, if one of their faces has no edge between these.
std::optional<std::array<std::array<Rational, 3>, 2>> shared_diagonal(const Surface& surface, std::size_t one,
                                                                      const Face& f, std::size_t other, const Face& g) {
  const std::array<Index, 3> of_f{f.a, f.b, f.c}, of_g{g.a, g.b, g.c};
  const auto place = [&of_g](Index v) {
    return static_cast<std::size_t>(std::find(of_g.begin(), of_g.end(), v) - of_g.begin());
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, in_g = place(of_f[k]), next_in_g = place(of_f[l]);
    if (in_g == 3 || next_in_g == 3) continue;
    if (surface.has_edge(one, of_f[k], of_f[l]) && surface.has_edge(other, of_f[k], of_f[l])) continue;
    std::array<std::array<Rational, 3>, 2> weights;
    weights[0][k] = weights[0][l] = weights[1][in_g] = weights[1][next_in_g] = Rational(1, 2);
    return weights;
  }
  return std::nullopt;
}

/// Returns whether two triangles meet; all faces have areas, and their boxes meet. If not, they may get a normal.
bool meet_polyhedron_complexity(const std::vector<Face>& list, const IntegerCloud& cloud, const Surface& surface,
                                const IndexPair& faces, const IndexPair& pair, Pairs& pairs) {
  const Face &f = list[pair.i], &g = list[pair.j];
  const auto note_meeting = [&](const std::array<Rational, 3>& on_first, const std::array<Rational, 3>& on_second) {
    pairs.weights.assign(on_first.begin(), on_first.end());
    pairs.weights.insert(pairs.weights.end(), on_second.begin(), on_second.end());
    pairs.triangles = {Rational(pair.i), Rational(pair.j)};
    return true;
  };
  Vector3<Integer> normal{0, 0, 0};
  if (!plainly_apart(cloud, f, g)) {
    const TwoFaces two(cloud, f, g);
    if (two.meet) return note_meeting(two.on_first, two.on_second);
    normal = two.normal;
  }
  if (const auto diagonal = shared_diagonal(surface, faces.i, f, faces.j, g))
    return note_meeting((*diagonal)[0], (*diagonal)[1]);
  if (!zero(normal))
    for (const Integer& n : {normal.x, normal.y, normal.z}) pairs.normals.emplace_back(n);
  return false;
}

/// Pairs of faces in the order of their indices, for each the pairs of their triangles, up to the first that meets.
Pairs paired(const std::vector<Face>& list, const std::vector<Index>& named, const Cuts& cuts,
             const IntegerCloud& cloud, const Surface& surface, PolyhedronComplexityAnswer& found) {
  const auto near = later_triangles_near(cloud, list);
  Pairs pairs;
  for (Index i = 0; i < cuts.size(); ++i) {
    std::vector<std::array<Index, 3>> others;  // the other face, the triangles of both
    for (const Index s : cuts[i])
      for (const Index t : near[s])
        if (named[t] != i) others.push_back({named[t], s, t});
    std::sort(others.begin(), others.end());
    std::size_t of_earlier_faces = 0;
    for (std::size_t k = 0; k < others.size(); ++k) {
      const auto& [j, s, t] = others[k];
      if (k == 0 || others[k - 1][0] != j) of_earlier_faces = pairs.normals.size();
      if (!meet_polyhedron_complexity(list, cloud, surface, {i, j}, {s, t}, pairs)) continue;
      found.meeting_faces = IndexPair{i, j};
      pairs.normals.resize(of_earlier_faces);  // of these faces one pair of triangles is enough
      return pairs;
    }
  }
  return pairs;
}

void look_for_flat_face(const std::vector<Face>& list, const Cuts& cuts, const IntegerCloud& cloud,
                        PolyhedronComplexityAnswer& found) {
  for (Index i = 0; i < cuts.size(); ++i)
    for (const Index t : cuts[i])
      if (zero(cloud.normal(list[t].a, list[t].b, list[t].c))) note(found.flat_face, i);
}

void look_for_splitting_face(const std::vector<Face>& list, const Cuts& cuts, const Surface& surface,
                             const IntegerCloud& cloud, PolyhedronComplexityAnswer& found) {
  std::vector<Index> used;
  for (const auto& [vertex, faces] : surface.at_vertex) used.push_back(vertex);
  const PointTree tree(cloud, used);
  for (Index i = 0; i < cuts.size() && !found.splitting_face; ++i) {
    const Face& f = list[cuts[i][0]];
    const SupportingPlane plane = cloud.plane(cloud.normal(f.a, f.b, f.c), f.a);
    const SupportingPlane turned{Integer(-1) * plane.normal, Integer(-plane.level)};
    if (!tree.any_beyond(plane) || !tree.any_beyond(turned)) continue;
    const auto first = [&](int side) {
      return *std::find_if(used.begin(), used.end(), [&](Index v) { return sgn(cloud.height(plane, v)) == side; });
    };
    found.splitting_face = SplittingFace{i, std::min(first(1), first(-1)), std::max(first(1), first(-1))};
  }
}

/// Six times the volume: for each face the doubled area seen from above, times the sum of the heights of its corners.
VolumeSign sign_of_volume(const std::vector<Face>& list, const IntegerCloud& cloud) {
  Integer sum;
  for (const Face& f : list) sum += cloud.normal(f.a, f.b, f.c).z * (cloud[f.a].z + cloud[f.b].z + cloud[f.c].z);
  return sgn(sum) > 0 ? VolumeSign::positive : sgn(sum) < 0 ? VolumeSign::negative : VolumeSign::zero;
}

/// The solid that some triangles bound, over their own corners.
Solid solid_of(const std::vector<Face>& triangles, const IntegerCloud& cloud) {
  std::map<Index, Index> places;
  std::vector<Point3<Integer>> vertices;
  const auto place = [&](Index v) {
    const auto [found, added] = places.emplace(v, static_cast<Index>(vertices.size()));
    if (added) vertices.push_back(cloud[v]);
    return found->second;
  };
  std::vector<Face> faces;
  for (const auto& [a, b, c] : triangles) faces.push_back({place(a), place(b), place(c)});
  return Solid(std::move(vertices), std::move(faces), cloud.unit);
}

/// For a closed embedded mesh. Returns the directions of the rays, one after the other.
std::vector<Rational> nest(const std::vector<Face>& list, const Cuts& cuts,
                           const std::vector<std::set<std::size_t>>& components, const IntegerCloud& cloud,
                           PolyhedronComplexityAnswer& found) {
  std::vector<Rational> directions;
  found.nesting.emplace();
  for (Index i = 0; i < components.size(); ++i) {
    std::vector<Face> triangles;
    for (const std::size_t face : components[i])
      for (const Index t : cuts[face]) triangles.push_back(list[t]);
    const Solid outer = solid_of(triangles, cloud);
    const auto in_box = [&outer](const Point3<Integer>& p) {
      for (Integer Point3<Integer>::*axis : {&Point3<Integer>::x, &Point3<Integer>::y, &Point3<Integer>::z}) {
        const auto below = [axis](const auto& one, const auto& other) { return one.*axis < other.*axis; };
        const auto [least, greatest] = std::minmax_element(outer.vertices().begin(), outer.vertices().end(), below);
        if (below(p, *least) || below(*greatest, p)) return false;
      }
      return true;
    };
    for (Index j = 0; j < components.size(); ++j) {
      const Point3<Integer>& inner = cloud[list[cuts[*components[j].begin()][0]].a];
      if (i == j || !in_box(inner)) continue;
      const Truth<Location> where =
          outer.locate_by_three_rays({Rational(inner.x), Rational(inner.y), Rational(inner.z)});
      if (where.answer == Location::inside) found.nesting->push_back({i, j});
      for (const auto& [name, values] : where.certificate().facts)
        if (name == "direction") directions.insert(directions.end(), values.begin(), values.end());
    }
  }
  return directions;
}

template <class Number>
Truth<PolyhedronComplexityAnswer> truth_of_polyhedron_complexity(const Mesh<Number>& mesh) {
  validation::validate("mesh", mesh), validate_polygons("mesh", mesh), validation::validate_triangles("mesh", mesh);
  const Surface surface(mesh);
  const Cuts cuts = cuts_of(mesh);
  PolyhedronComplexityAnswer found = counted(surface);
  const auto parts = components(surface);
  found.components = static_cast<Index>(parts.size());
  const IntegerCloud cloud(mesh.vertices);
  if (found.closed && found.oriented) found.volume = sign_of_volume(mesh.faces, cloud);
  look_for_flat_face(mesh.faces, cuts, cloud, found);
  Pairs pairs;
  if (!found.flat_face) pairs = paired(mesh.faces, named_face_of_each(mesh), cuts, cloud, surface, found);
  found.embedded = !found.flat_face && !found.meeting_faces;
  std::vector<Rational> directions;
  if (found.closed && found.embedded) {
    look_for_splitting_face(mesh.faces, cuts, surface, cloud, found);
    found.convex = !found.splitting_face;
    directions = nest(mesh.faces, cuts, parts, cloud, found);
  }
  const bool polygons = !mesh.polygons.empty();
  return {found, std::nullopt, [pairs = std::move(pairs), directions = std::move(directions), polygons] {
            Certificate certificate{
                "complexity",
                {{"normals", pairs.normals}, {"common_point", pairs.weights}, {"directions", directions}}};
            if (polygons) certificate.facts.emplace_back("triangles", pairs.triangles);
            return certificate;
          }};
}

}  // namespace

template <Exact Number>
Truth<PolyhedronComplexity<Rational>> polyhedron_complexity(const Mesh<Number>& mesh) {
  return truth_of_polyhedron_complexity(mesh);
}
template Truth<PolyhedronComplexityAnswer> polyhedron_complexity(const Meshd&);
template Truth<PolyhedronComplexity<Rational>> polyhedron_complexity(const Mesh<Rational>&);

}  // namespace touchstone::oracle
