// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <utility>

#include "catalogue/families/list_draws.h"
#include "catalogue/families/meshes/mesh_draws.h"
#include "catalogue/families/space_draws.h"

/// Two convex solids at known places near each other, drawn from a draw stream.
namespace touchstone::catalogue {

inline Meshd reflected(Meshd mesh, const Point3d& in) {
  for (Point3d& p : mesh.vertices) p = {2 * in.x - p.x, 2 * in.y - p.y, 2 * in.z - p.z};
  return mesh;
}

/// Two lattice polyhedra, a point on or near the surface of each, n lattice vectors apart.
inline std::tuple<Meshd, Meshd> aimed(DrawStream& c, double n) {
  const Meshd a = lattice_polyhedron(c), b = lattice_polyhedron(c);
  const Point3d p = on_a_face_plane(a, c), q = on_a_face_plane(b, c);
  return {a, shifted(b, (p - q) + n * lattice_normal(c, 4))};
}

/// A corner of a face, and what is at a right angle to it.
inline std::pair<Point3d, Vector3d> corner_of_face(const Meshd& mesh, DrawStream& c) {
  const Face& f = mesh.faces[c.below(mesh.faces.size())];
  const Point3d& p = mesh.vertices[f.a];
  return {p, cross(mesh.vertices[f.b] - p, mesh.vertices[f.c] - p)};
}

inline Meshd with_repeated_vertex(Meshd mesh, DrawStream& c) {
  const Point3d again = mesh.vertices[c.below(mesh.vertices.size())];
  if (c.coin()) {
    mesh.vertices.push_back(again);
    return mesh;
  }
  mesh.vertices.insert(mesh.vertices.begin(), again);
  for (Face& f : mesh.faces) f = {f.a + 1, f.b + 1, f.c + 1};
  return mesh;
}

/// Below or above a ridge.
inline Meshd roof(const Point3d& from, const Point3d& to, double height) {
  const double z = from.z + height;
  return tetrahedron_over({{from, to, {from.x, -8, z}, {from.x, 8, z}}});
}

/// Many vertices of no face, and a tetrahedron around them whose corners are among the last.
inline Meshd with_late_corners(DrawStream& c) {
  const double size = 4096;
  Meshd mesh{long_list(c, [](DrawStream& d) { return lattice_point_in_space(d, 8); }), {}};
  const Point3d corners[]{{-size, -size, -size}, {4 * size, 0, 0}, {0, 4 * size, 0}, {0, 0, 4 * size}};
  Index at[4];
  for (std::size_t k = 0; k < 4; ++k) {
    at[k] = static_cast<Index>(mesh.vertices.size());
    mesh.vertices.push_back(corners[k]);
  }
  mesh.vertices.push_back(lattice_point_in_space(c, 8));
  mesh.faces = {{at[0], at[2], at[1]}, {at[0], at[1], at[3]}, {at[0], at[3], at[2]}, {at[1], at[2], at[3]}};
  return mesh;
}

}  // namespace touchstone::catalogue
