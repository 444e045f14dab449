// SPDX-License-Identifier: Apache-2.0
#include "robust/polyhedra/polyhedron_complexity.h"

#include <vector>

#include "geometry/validation.h"
#include "robust/kernel/filters/ordered_bits.h"
#include "robust/kernel/solids/polygon_faces.h"
#include "robust/polyhedra/point_in_polyhedron.h"
#include "robust/structures/connected_mesh.h"
#include "robust/structures/embedded_mesh.h"
#include "robust/structures/solid_mesh.h"
#include "robust/structures/sort_and_sweep.h"

namespace touchstone::robust {
namespace {

/// Each component of the mesh separately, over its own vertices, in the order in which its faces use them.
std::vector<Meshd> parts_of(const Meshd& mesh, const std::vector<Index>& components) {
  std::vector<Meshd> parts;
  std::vector<Index> place(mesh.vertices.size());
  std::vector<bool> placed(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    if (components[i] == parts.size()) parts.emplace_back();
    Meshd& part = parts[components[i]];
    const Face& f = mesh.faces[i];
    for (const Index v : {f.a, f.b, f.c}) {
      if (placed[v]) continue;
      placed[v] = true, place[v] = static_cast<Index>(part.vertices.size());
      part.vertices.push_back(mesh.vertices[v]);
    }
    part.faces.push_back({place[f.a], place[f.b], place[f.c]});
  }
  return parts;
}

Aabb3d box_of(const Meshd& part) {
  Aabb3d box{part.vertices[0], part.vertices[0]};
  for (const Point3d& p : part.vertices) {
    for (double Point3d::*axis : structures::coordinates) {
      const std::int64_t at = kernel::ordered_bits(p.*axis);
      if (at < kernel::ordered_bits(box.min.*axis)) box.min.*axis = p.*axis;
      if (at > kernel::ordered_bits(box.max.*axis)) box.max.*axis = p.*axis;
    }
  }
  return box;
}

/// The pairs of components of a closed embedded mesh of which one contains the other, by a vertex of each. components:
/// that of each face.
std::vector<IndexPair> nesting(const Meshd& mesh, const std::vector<Index>& components) {
  const std::vector<Meshd> parts = parts_of(mesh, components);
  std::vector<Aabb3d> boxes;
  for (const Meshd& part : parts) boxes.push_back(box_of(part));
  std::vector<IndexPair> found;
  const auto note = [&](Index outer, Index inner) {
    const auto inside = stages::point_in_polyhedron::of_valid(parts[outer], parts[inner].vertices[0]).answer;
    if (inside == Location::inside) found.push_back({outer, inner});
  };
  for (const auto& [i, j] : structures::swept_pairs(boxes)) note(i, j), note(j, i);
  using structures::sorted_by;
  return sorted_by(&IndexPair::i, sorted_by(&IndexPair::j, found, parts.size()), parts.size());
}

}  // namespace

PolyhedronComplexity<double> polyhedron_complexity(const Meshd& mesh) {
  validation::validate("mesh", mesh), kernel::validate_polygons("mesh", mesh);
  validation::validate_triangles("mesh", mesh);
  const structures::ConnectedMesh connected(mesh);
  PolyhedronComplexity<double> found = connected.found;
  if (found.closed && found.oriented) found.volume = structures::sign_of_volume(mesh);
  found.flat_face = structures::first_flat_face(mesh);
  const bool surface = found.closed && found.oriented && found.vertex_manifold;
  if (!found.flat_face) found.meeting_faces = structures::first_meeting_faces(mesh, surface);
  found.embedded = !found.flat_face && !found.meeting_faces;
  if (!found.closed || !found.embedded) return found;
  const auto bends_one_way = [&] {
    if (mesh.polygons.empty()) return structures::locally_convex(mesh, connected.sides);
    return structures::locally_convex(mesh, {mesh.vertices.size(), structures::FaceCorners(mesh.faces)});
  };
  const bool one_surface = found.components == 1 && found.vertex_manifold && found.oriented;
  if (!one_surface || !bends_one_way()) found.splitting_face = structures::first_splitting_face(mesh);
  found.convex = !found.splitting_face;
  found.nesting.emplace();
  if (found.components > 1) found.nesting = nesting(mesh, connected.component);
  return found;
}

}  // namespace touchstone::robust
