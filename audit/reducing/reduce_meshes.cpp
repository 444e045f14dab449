// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>

#include "audit/reducing/mesh_parts.h"
#include "audit/reducing/passes.h"
#include "audit/reducing/question_parts.h"
#include "audit/reducing/runs.h"

namespace touchstone::audit::reducing {
namespace {

/// One of the meshes of the best question.
class MeshOfBest {
 public:
  MeshOfBest(Search& search, std::size_t number) : search_(search), number_(number) { read(); }

  /// Call when the best question may have changed.
  void read() {
    const QuestionParts parts = parts_of(*search_.operation().row().question, search_.best());
    place_ = parts.meshes[number_];
    Cursor<double> at(search_.best());
    at.number += place_.begin.number, at.word += place_.begin.word;
    Meshd mesh;
    unpack(mesh, at, as_it_is);
    faces_ = faces_of(mesh);
    has_polygons_ = !mesh.polygons.empty();
  }
  const FacesOfMesh& faces() const { return faces_; }
  bool has_polygons() const { return has_polygons_; }
  std::optional<Question> with(std::optional<FacesOfMesh> other) const {
    if (!other) return std::nullopt;
    const std::optional<Meshd> mesh = mesh_of(*std::move(other));
    if (!mesh) return std::nullopt;
    return with_part(search_.best(), place_, packed(*mesh));
  }

 private:
  Search& search_;
  std::size_t number_;
  Extent place_{};
  FacesOfMesh faces_;
  bool has_polygons_ = false;
};

/// Replaces polygons by their triangles.
bool forget_polygons(Search& search, MeshOfBest& mesh) {
  if (!mesh.has_polygons()) return false;
  const auto triangles = [&](std::size_t) {
    const std::optional<Meshd> cut = mesh_of(mesh.faces());
    return cut ? mesh.with(faces_of({cut->vertices, cut->faces, {}})) : std::nullopt;
  };
  const bool better = search.first(1, triangles).has_value();
  mesh.read();
  return better;
}

bool drop_components(Search& search, MeshOfBest& mesh) {
  std::vector<std::size_t> component;
  const auto count = [&]() -> std::size_t {
    mesh.read();
    component = components_of(mesh.faces());
    return component.empty() ? 0 : *std::max_element(component.begin(), component.end()) + 1;
  };
  const auto without_some = [&](std::size_t first, std::size_t last) {
    std::vector<bool> kept(component.size());
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = component[i] < first || component[i] >= last;
    return mesh.with(with_faces(mesh.faces(), kept));
  };
  return count() > 1 && drop_runs(search, {count, without_some});
}

bool drop_faces(Search& search, MeshOfBest& mesh) {
  const auto count = [&] {
    mesh.read();
    return mesh.faces().faces.size();
  };
  const auto without_some = [&](std::size_t first, std::size_t last) {
    std::vector<bool> kept(mesh.faces().faces.size(), true);
    std::fill(kept.begin() + static_cast<std::ptrdiff_t>(first), kept.begin() + static_cast<std::ptrdiff_t>(last),
              false);
    return mesh.with(with_faces(mesh.faces(), kept));
  };
  return drop_runs(search, {count, without_some, 1, true});
}

/// Merges runs of vertices that are near each other; then single vertices with one of their neighbours.
bool merge_vertices(Search& search, MeshOfBest& mesh) {
  std::vector<Index> order;
  const auto count = [&] {
    mesh.read();
    order = along_curve(mesh.faces());
    return order.size();
  };
  const auto as_one = [&](std::size_t first, std::size_t last) -> std::optional<Question> {
    if (last - first < 2) return std::nullopt;
    std::vector<Index> to(mesh.faces().vertices.size());
    std::iota(to.begin(), to.end(), Index{0});
    const Index stays = order[first + (last - first) / 2];
    for (std::size_t i = first; i < last; ++i) to[order[i]] = stays;
    return mesh.with(merged(mesh.faces(), to));
  };
  return drop_runs(search, {count, as_one, 2, true});
}

bool merge_along_edges(Search& search, MeshOfBest& mesh) {
  bool better = false;
  std::vector<std::vector<Index>> neighbours;
  const auto read = [&] {
    mesh.read();
    neighbours = neighbours_of(mesh.faces());
  };
  read();
  for (std::size_t v = 0; v < neighbours.size() && !search.over();) {
    const auto as_neighbour = [&](std::size_t i) {
      std::vector<Index> to(neighbours.size());
      std::iota(to.begin(), to.end(), Index{0});
      to[v] = neighbours[v][i];
      return mesh.with(merged(mesh.faces(), to));
    };
    if (search.first(neighbours[v].size(), as_neighbour)) {
      better = true;
      read();
    } else {
      ++v;
    }
  }
  return better;
}

/// Drops vertices that no face uses.
bool drop_vertices_alone(Search& search, MeshOfBest& mesh) {
  std::vector<Index> alone;
  const auto count = [&] {
    mesh.read();
    const FacesOfMesh& faces = mesh.faces();
    std::vector<bool> named(faces.vertices.size());
    for (const meshes::Corners& face : faces.faces)
      for (const Index v : face) named[v] = true;
    alone.clear();
    for (std::size_t i = 0; i < named.size(); ++i)
      if (!named[i]) alone.push_back(static_cast<Index>(i));
    return alone.size();
  };
  const auto without_some = [&](std::size_t first, std::size_t last) {
    std::vector<bool> dropped(mesh.faces().vertices.size());
    for (std::size_t i = first; i < last; ++i) dropped[alone[i]] = true;
    return mesh.with(without_vertices(mesh.faces(), dropped));
  };
  return drop_runs(search, {count, without_some});
}

/// For operations that take only convex meshes, and if nothing else about the mesh matters.
bool take_hulls(Search& search, MeshOfBest& mesh) {
  mesh.read();
  const auto hull = mesh.with(hull_of(mesh.faces().vertices));
  if (!hull || !search.holds(*hull)) return false;
  const auto count = [&] {
    mesh.read();
    return mesh.faces().vertices.size();
  };
  const auto without_some = [&](std::size_t first, std::size_t last) -> std::optional<Question> {
    std::vector<Point3d> vertices = mesh.faces().vertices;
    vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(first),
                   vertices.begin() + static_cast<std::ptrdiff_t>(last));
    if (vertices.size() < 4) return std::nullopt;
    return mesh.with(hull_of(vertices));
  };
  return drop_runs(search, {count, without_some});
}

}  // namespace

bool reduce_meshes(Search& search) {
  bool better = false;
  const std::size_t meshes = parts_of(*search.operation().row().question, search.best()).meshes.size();
  for (std::size_t number = 0; number < meshes; ++number) {
    MeshOfBest mesh(search, number);
    for (auto* pass : {forget_polygons, drop_components, drop_faces, merge_vertices, take_hulls, merge_along_edges,
                       drop_vertices_alone}) {
      if (!search.over()) better = pass(search, mesh) || better;
    }
  }
  return better;
}

}  // namespace touchstone::audit::reducing
