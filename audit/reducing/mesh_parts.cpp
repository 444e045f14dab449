// SPDX-License-Identifier: Apache-2.0
#include "audit/reducing/mesh_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "geometry/invalid_input.h"
#include "robust/structures/polygon_mesh.h"
#include "robust/volumes/convex_hull.h"

namespace touchstone::audit::reducing {
namespace {

using meshes::Corners;

std::vector<bool> named_vertices(const FacesOfMesh& mesh) {
  std::vector<bool> named(mesh.vertices.size());
  for (const Corners& face : mesh.faces)
    for (const Index v : face) named[v] = true;
  return named;
}

/// Removes the vertices for which `named_before` is true and that no face uses any more.
FacesOfMesh without_unnamed(FacesOfMesh mesh, const std::vector<bool>& named_before) {
  std::vector<bool> dropped = named_before;
  const std::vector<bool> named = named_vertices(mesh);
  for (std::size_t i = 0; i < dropped.size(); ++i) dropped[i] = dropped[i] && !named[i];
  return without_vertices(std::move(mesh), dropped);
}

/// Spreads the lower 21 bits, with two zeros after each.
std::uint64_t spread_bits(std::uint64_t bits) {
  std::uint64_t spread = 0;
  for (int i = 0; i < 21; ++i) spread |= (bits >> i & 1) << (3 * i);
  return spread;
}

}  // namespace

FacesOfMesh faces_of(const Meshd& mesh) {
  FacesOfMesh faces{mesh.vertices, mesh.polygons};
  if (mesh.polygons.empty()) {
    faces.faces.reserve(mesh.faces.size());
    for (const Face& face : mesh.faces) faces.faces.push_back({face.a, face.b, face.c});
  }
  return faces;
}

std::optional<Meshd> mesh_of(FacesOfMesh mesh) {
  const auto is_triangle = [](const Corners& face) { return face.size() == 3; };
  if (std::all_of(mesh.faces.begin(), mesh.faces.end(), is_triangle)) {
    Meshd made{std::move(mesh.vertices), {}, {}};
    made.faces.reserve(mesh.faces.size());
    for (const Corners& face : mesh.faces) made.faces.push_back({face[0], face[1], face[2]});
    return made;
  }
  try {
    return robust::polygon_mesh(std::move(mesh.vertices), std::move(mesh.faces));
  } catch (const InvalidInput&) {
    return std::nullopt;
  }
}

std::vector<std::size_t> components_of(const FacesOfMesh& mesh) {
  std::vector<Index> up(mesh.vertices.size());
  for (std::size_t i = 0; i < up.size(); ++i) up[i] = static_cast<Index>(i);
  const auto root = [&up](Index v) {
    while (up[v] != v) v = up[v] = up[up[v]];
    return v;
  };
  for (const Corners& face : mesh.faces)
    for (const Index v : face) up[root(v)] = root(face[0]);
  std::map<Index, std::size_t> numbers;
  std::vector<std::size_t> component;
  component.reserve(mesh.faces.size());
  for (const Corners& face : mesh.faces)
    component.push_back(numbers.emplace(root(face[0]), numbers.size()).first->second);
  return component;
}

FacesOfMesh without_vertices(FacesOfMesh mesh, const std::vector<bool>& dropped) {
  std::vector<Index> place(mesh.vertices.size());
  Index next = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (dropped[i]) continue;
    mesh.vertices[next] = mesh.vertices[i];
    place[i] = next++;
  }
  mesh.vertices.resize(next);
  for (Corners& face : mesh.faces)
    for (Index& v : face) v = place[v];
  return mesh;
}

FacesOfMesh with_faces(const FacesOfMesh& mesh, const std::vector<bool>& kept) {
  const std::vector<bool> named = named_vertices(mesh);
  FacesOfMesh result{mesh.vertices, {}};
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i]) result.faces.push_back(mesh.faces[i]);
  return without_unnamed(std::move(result), named);
}

FacesOfMesh merged(const FacesOfMesh& mesh, const std::vector<Index>& to) {
  FacesOfMesh result{mesh.vertices, {}};
  std::vector<std::size_t> changed;
  for (const Corners& face : mesh.faces) {
    Corners corners;
    for (const Index v : face)
      if (corners.empty() || corners.back() != to[v]) corners.push_back(to[v]);
    while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    if (corners.size() < 3) continue;
    if (corners != face) changed.push_back(result.faces.size());
    result.faces.push_back(std::move(corners));
  }
  // An even number of equal faces, whatever their orientation, separates nothing.
  std::map<Corners, std::size_t> alone;
  std::vector<bool> kept(result.faces.size(), true);
  for (const std::size_t i : changed) {
    Corners key = result.faces[i];
    std::sort(key.begin(), key.end());
    const auto [other, added] = alone.emplace(std::move(key), i);
    if (added) continue;
    kept[i] = kept[other->second] = false;
    alone.erase(other);
  }
  std::vector<Corners> faces;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i]) faces.push_back(std::move(result.faces[i]));
  result.faces = std::move(faces);
  std::vector<bool> named = named_vertices(mesh);
  for (std::size_t i = 0; i < to.size(); ++i) named[i] = named[i] || to[i] != i;
  return without_unnamed(std::move(result), named);
}

std::optional<FacesOfMesh> hull_of(const std::vector<Point3d>& vertices) {
  const auto finite = [](const Point3d& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); };
  if (vertices.empty() || !std::all_of(vertices.begin(), vertices.end(), finite)) return std::nullopt;
  const ConvexHull hull = robust::convex_hull(vertices);
  if (!hull.faces) return std::nullopt;
  FacesOfMesh mesh{vertices, {}};
  for (const Face& face : *hull.faces) mesh.faces.push_back({face.a, face.b, face.c});
  return without_unnamed(std::move(mesh), std::vector<bool>(vertices.size(), true));
}

std::vector<Index> along_curve(const FacesOfMesh& mesh) {
  const std::vector<bool> named = named_vertices(mesh);
  std::array<double, 3> low{}, high{};
  bool first = true;
  const auto each = [&](const auto& visit) {
    for (std::size_t i = 0; i < named.size(); ++i)
      if (named[i])
        visit(static_cast<Index>(i), std::array{mesh.vertices[i].x, mesh.vertices[i].y, mesh.vertices[i].z});
  };
  each([&](Index, const std::array<double, 3>& p) {
    for (std::size_t k = 0; k < 3; ++k)
      low[k] = first ? p[k] : std::fmin(low[k], p[k]), high[k] = first ? p[k] : std::fmax(high[k], p[k]);
    first = false;
  });
  std::vector<std::pair<std::uint64_t, Index>> order;
  each([&](Index v, const std::array<double, 3>& p) {
    std::uint64_t place = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double share = (p[k] / 2 - low[k] / 2) / (high[k] / 2 - low[k] / 2);
      place |= spread_bits(share > 0 ? static_cast<std::uint64_t>(share * 0x1.fffffp20) : 0) << k;
    }
    order.emplace_back(place, v);
  });
  std::sort(order.begin(), order.end());
  std::vector<Index> vertices;
  for (const auto& [place, v] : order) vertices.push_back(v);
  return vertices;
}

std::vector<std::vector<Index>> neighbours_of(const FacesOfMesh& mesh) {
  std::vector<std::vector<Index>> neighbours(mesh.vertices.size());
  for (const Corners& face : mesh.faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Index a = face[i], b = face[(i + 1) % face.size()];
      neighbours[a].push_back(b), neighbours[b].push_back(a);
    }
  }
  for (std::vector<Index>& of_one : neighbours) {
    std::sort(of_one.begin(), of_one.end());
    of_one.erase(std::unique(of_one.begin(), of_one.end()), of_one.end());
  }
  return neighbours;
}

}  // namespace touchstone::audit::reducing
