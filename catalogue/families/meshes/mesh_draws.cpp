// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/meshes/mesh_draws.h"

#include <algorithm>
#include <cstdint>

#include "catalogue/families/meshes/lattice_hull.h"
#include "catalogue/families/meshes/named_meshes.h"
#include "catalogue/families/numbers.h"

namespace touchstone::catalogue {
namespace {

std::vector<LatticePoint> drawn_points(DrawStream& draws) {
  switch (draws.below(4)) {
    case 0: return {{0, 0, 0}, {12, 0, 0}, {0, 12, 0}, {0, 0, 12}};
    case 1: {
      std::vector<LatticePoint> cube;
      for (std::int64_t i = 0; i < 8; ++i) cube.push_back({12 * (i & 1), 12 * (i >> 1 & 1), 12 * (i >> 2)});
      return cube;
    }
    case 2: return {{12, 0, 0}, {-12, 0, 0}, {0, 12, 0}, {0, -12, 0}, {0, 0, 12}, {0, 0, -12}};
    default: break;
  }
  std::vector<LatticePoint> points;
  for (std::uint64_t left = 5 + draws.below(5); left > 0; --left) {
    const auto coordinate = [&draws] { return 12 * static_cast<std::int64_t>(small_integer(draws, 4)); };
    const std::int64_t x = coordinate(), y = coordinate(), z = coordinate();
    if (std::find(points.begin(), points.end(), LatticePoint{x, y, z}) == points.end()) points.push_back({x, y, z});
  }
  return points;
}

void turn_over(Face& face) { std::swap(face.b, face.c); }

Point3d middle(const Point3d& p, const Point3d& q) { return {(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2}; }

}  // namespace

Meshd lattice_polyhedron(DrawStream& draws) {
  Meshd mesh = lattice_hull(drawn_points(draws));
  if (mesh.faces.empty()) mesh = lattice_hull({{0, 0, 0}, {12, 0, 0}, {0, 12, 0}, {0, 0, 12}});
  mesh = relisted(mesh, draws);
  if (draws.one_in(4)) turn_inside_out(mesh);
  return mesh;
}

void turn_inside_out(Meshd& mesh) { std::for_each(mesh.faces.begin(), mesh.faces.end(), turn_over); }

Meshd around_the_mean(Meshd mesh) {
  const auto count = static_cast<double>(mesh.vertices.size());
  Point3d sum{0, 0, 0};
  for (const Point3d& p : mesh.vertices) sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
  for (Point3d& p : mesh.vertices) p = {count * p.x - sum.x, count * p.y - sum.y, count * p.z - sum.z};
  return mesh;
}

Meshd relisted(Meshd mesh, DrawStream& draws) {
  for (std::size_t i = mesh.faces.size(); i-- > 1;) std::swap(mesh.faces[i], mesh.faces[i - draws.below(i + 1)]);
  for (Face& face : mesh.faces) {
    if (draws.below(3) == 1) face = {face.b, face.c, face.a};
  }
  return mesh;
}

Meshd together(Meshd mesh, const Meshd& other) {
  const auto shift = static_cast<Index>(mesh.vertices.size());
  if (!mesh.polygons.empty() || !other.polygons.empty()) {
    std::vector<std::vector<Index>> polygons;
    for (std::size_t i = 0; i < named_faces(mesh); ++i) polygons.push_back(corners_of_named(mesh, i));
    for (std::size_t i = 0; i < named_faces(other); ++i) {
      polygons.push_back(corners_of_named(other, i));
      for (Index& corner : polygons.back()) corner += shift;
    }
    mesh.polygons = std::move(polygons);
  }
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const Face& f : other.faces) mesh.faces.push_back({f.a + shift, f.b + shift, f.c + shift});
  return mesh;
}

const Meshd& named_mesh(DrawStream& draws) {
  const auto& all = named_meshes();
  return all[draws.below(all.size())].mesh;
}

Meshd with_flat_vertex(const Meshd& mesh, DrawStream& draws) {
  Meshd result = mesh;
  const auto added = static_cast<Index>(mesh.vertices.size());
  const Face face = mesh.faces[draws.below(mesh.faces.size())];
  const Point3d &a = mesh.vertices[face.a], &b = mesh.vertices[face.b], &c = mesh.vertices[face.c];
  if (!draws.coin()) {
    result.vertices.push_back({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3});
    std::replace(result.faces.begin(), result.faces.end(), face, Face{face.a, face.b, added});
    result.faces.push_back({face.b, face.c, added});
    result.faces.push_back({face.c, face.a, added});
    return result;
  }
  result.vertices.push_back(middle(a, b));
  result.faces.clear();
  for (const Face& f : mesh.faces) {
    Face g = f;
    for (int turn = 0; turn < 3; ++turn, g = {g.b, g.c, g.a}) {
      if ((g.a == face.a && g.b == face.b) || (g.a == face.b && g.b == face.a)) break;
      if (turn == 2) g = {f.b, f.c, f.a};
    }
    const bool split = (g.a == face.a && g.b == face.b) || (g.a == face.b && g.b == face.a);
    if (!split) {
      result.faces.push_back(f);
      continue;
    }
    result.faces.push_back({g.a, added, g.c});
    result.faces.push_back({added, g.b, g.c});
  }
  return result;
}

Point3d on_a_face_plane(const Meshd& mesh, DrawStream& draws) {
  const Face face = mesh.faces[draws.below(mesh.faces.size())];
  const Point3d &a = mesh.vertices[face.a], &b = mesh.vertices[face.b], &c = mesh.vertices[face.c];
  switch (draws.below(5)) {
    case 0: return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3};
    case 1: return middle(a, b);
    case 2: return a;
    case 3: return a + (a - b);
    default: return a + (b - c);
  }
}

Point3d between_vertices(const Meshd& mesh, DrawStream& draws) {
  const std::size_t first = draws.below(mesh.vertices.size()), second = draws.below(mesh.vertices.size());
  return middle(mesh.vertices[first], mesh.vertices[second]);
}

Meshd broken(Meshd mesh, DrawStream& draws) {
  const std::size_t which = draws.below(mesh.faces.size());
  switch (draws.below(7)) {
    case 0: mesh.faces.erase(mesh.faces.begin() + static_cast<std::ptrdiff_t>(which)); break;
    case 1: mesh.faces.push_back(mesh.faces[which]); break;
    case 2: turn_over(mesh.faces[which]); break;
    case 3: mesh.faces[which].b = mesh.faces[which].a; break;
    case 4:
      for (Point3d& vertex : mesh.vertices) vertex.z = 0;
      break;
    case 5: break;  // intact, so that the family has answers too
    default: {
      const auto count = static_cast<Index>(mesh.vertices.size());
      const std::vector<Face> faces = mesh.faces;
      for (Index i = 0; i < count; ++i) mesh.vertices.push_back(mesh.vertices[i] + Vector3d{120, 0, 0});
      for (const Face& f : faces) mesh.faces.push_back({f.a + count, f.b + count, f.c + count});
    }
  }
  return mesh;
}

Meshd tetrahedron_over(const std::array<Point3d, 4>& corners) {
  Meshd mesh{{corners.begin(), corners.end()}, {}};
  make_tetrahedron(mesh);
  return mesh;
}

void make_tetrahedron(Meshd& mesh) {
  mesh.polygons.clear();
  if (mesh.vertices.size() < 4) return;
  mesh.vertices.resize(4);
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
}

}  // namespace touchstone::catalogue
