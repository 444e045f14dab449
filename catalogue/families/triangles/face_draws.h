// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "catalogue/families/meshes/contact_mesh_draws.h"
#include "catalogue/families/meshes/mesh_draws.h"
#include "catalogue/families/meshes/solid_draws.h"
#include "geometry/ray_mesh.h"

/// Faces that need not be closed, drawn from a draw stream.
namespace touchstone::catalogue {

inline Meshd some_faces(DrawStream& c) {
  switch (c.below(4)) {
    case 0: return lattice_solid(c);
    case 1: return lattice_polyhedron(c);
    case 2: return flat_part(c);
    default: return folded_flap(c);
  }
}

inline Point3d some_vertex(const Meshd& mesh, DrawStream& c) { return mesh.vertices[c.below(mesh.vertices.size())]; }

/// Each with three vertices of its own.
inline Meshd mesh_of_triangles(const std::vector<Triangle3d>& triangles) {
  Meshd mesh;
  for (const Triangle3d& t : triangles) {
    const auto i = static_cast<Index>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {t.a, t.b, t.c});
    mesh.faces.push_back({i, i + 1, i + 2});
  }
  return mesh;
}

/// Up to five faces, each over three vertices that follow each other in the list; the others are taken away.
inline void make_strip(Meshd& mesh) {
  mesh.vertices.resize(std::min<std::size_t>(mesh.vertices.size(), 7));
  const auto count = static_cast<Index>(mesh.vertices.size());
  mesh.faces.clear(), mesh.polygons.clear();
  for (Index i = 0; i + 2 < count; ++i) mesh.faces.push_back({i, i + 1, i + 2});
}

/// Beyond the digits of floats, in which boxes are compared.
inline Vector3d far_displacement(DrawStream& c) {
  const auto far = [&c] {
    const double sign = either_sign(c);
    return sign * power_of_two(c, 18, 40);
  };
  return {far(), far(), far()};
}

}  // namespace touchstone::catalogue
