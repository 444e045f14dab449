// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "catalogue/families/meshes/cube_surface.h"
#include "geometry/volumes.h"

/// Closed meshes for worked examples, and what laws do to them.
namespace touchstone::proptests::solids {

using catalogue::cube_surface;

/// [0, 12]^3, and three of these at an angle, nine but the one in the middle, 27 but the one in the middle; two that
/// share an edge, and two a corner.
inline const Meshd cube = cube_surface({{0, 0, 0}}), angle = cube_surface({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
                   edge_to_edge = cube_surface({{0, 0, 0}, {1, 1, 0}}),
                   corner_to_corner = cube_surface({{0, 0, 0}, {1, 1, 1}});
inline Meshd but_the_middle(std::int64_t height) {
  std::vector<catalogue::LatticePoint> cells;
  for (std::int64_t i = 0; i < 9 * height; ++i) {
    if (i != 9 * height / 2) cells.push_back({i % 3, i / 3 % 3, i / 9});
  }
  return cube_surface(cells);
}
inline const Meshd ring = but_the_middle(1), hollow = but_the_middle(3);
inline const Meshd octahedron{{{12, 0, 0}, {-12, 0, 0}, {0, 12, 0}, {0, -12, 0}, {0, 0, 12}, {0, 0, -12}},
                              {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};

/// Vertex number x + 2 y + 4 z of a box.
inline const std::vector<Face> box_faces{{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                                         {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
inline Meshd mesh_of(const Aabb3d& box) {
  Meshd mesh{{}, box_faces};
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back({(i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
                             (i & 4) != 0 ? box.max.z : box.min.z});
  return mesh;
}
inline Aabb3d box_around(const Meshd& mesh) {
  Aabb3d box{mesh.vertices[0], mesh.vertices[0]};
  for (const Point3d& p : mesh.vertices) {
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
  }
  return box;
}
/// A corner, and three more at the ends of these edges.
inline Meshd tetrahedron(const Point3d& p, const Vector3d& u, const Vector3d& v, const Vector3d& w) {
  return {{p, p + u, p + v, p + w}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

/// Where faces are polygons, these three speak of the triangles of their cut.
template <class Change>
Meshd with_each_face(Meshd mesh, const Change& change) {
  mesh.polygons.clear();
  std::for_each(mesh.faces.begin(), mesh.faces.end(), change);
  return mesh;
}

/// Whether a law `holds` where the corners of faces, the faces, or the vertices are listed in another order.
template <class Holds>
bool in_any_order(const Meshd& mesh, const Holds& holds) {
  const Meshd corners = with_each_face(mesh, [](Face& f) { f = {f.b, f.c, f.a}; });
  Meshd permuted{mesh.vertices, mesh.faces, {}};
  std::reverse(permuted.faces.begin(), permuted.faces.end());
  std::rotate(permuted.faces.begin(), permuted.faces.begin() + 1, permuted.faces.end());
  const auto last = static_cast<Index>(mesh.vertices.size() - 1);
  Meshd renumbered = with_each_face(mesh, [last](Face& f) { f = {last - f.a, last - f.b, last - f.c}; });
  std::reverse(renumbered.vertices.begin(), renumbered.vertices.end());
  return holds(corners) && holds(permuted) && holds(renumbered);
}

inline Meshd mapped(Meshd mesh, double factor, double shift = 0) {
  for (Point3d& p : mesh.vertices) p = {factor * p.x + shift, factor * p.y + shift, factor * p.z + shift};
  return mesh;
}

/// Two meshes as one list of vertices and one of faces.
inline Meshd together(Meshd mesh, const Meshd& other) {
  mesh.polygons.clear();
  const auto shift = static_cast<Index>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const Face& f : other.faces) mesh.faces.push_back({f.a + shift, f.b + shift, f.c + shift});
  return mesh;
}

inline Meshd with_faces(Meshd mesh, const std::vector<Face>& more) {
  mesh.polygons.clear();
  mesh.faces.insert(mesh.faces.end(), more.begin(), more.end());
  return mesh;
}
inline Meshd with_vertex(Meshd mesh, const Point3d& p) {
  mesh.vertices.push_back(p);
  return mesh;
}
inline Meshd shifted(Meshd mesh, const Vector3d& by) {
  for (Point3d& p : mesh.vertices) p = p + by;
  return mesh;
}

}  // namespace touchstone::proptests::solids
