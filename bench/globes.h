// SPDX-License-Identifier: Apache-2.0
#pragma once

// CGAL as peer: meshes as its algorithms take them.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/polyhedra.h"

namespace touchstone::bench {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Epick::Point_3>;

/// 4 n (n - 1) triangles between two poles; `place` maps a height in [0, pi] and an angle in [0, 2 pi) to a point.
template <class Place>
Meshd globe(Index n, const Place& place) {
  Meshd mesh;
  const auto add = [&](Index i, Index j) {
    mesh.vertices.push_back(place(std::numbers::pi * i / n, std::numbers::pi * j / n));
  };
  add(0, 0);
  for (Index i = 1; i < n; ++i)
    for (Index j = 0; j < 2 * n; ++j) add(i, j);
  add(n, 0);
  const auto at = [n](Index i, Index j) {
    return i == 0 ? 0 : i == n ? 1 + (n - 1) * 2 * n : 1 + (i - 1) * 2 * n + j % (2 * n);
  };
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < 2 * n; ++j) {
      if (i > 0) mesh.faces.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      if (i + 1 < n) mesh.faces.push_back({at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)});
    }
  }
  return mesh;
}

inline Point3d on_sphere(double height, double angle, double radius) {
  return {radius * std::sin(height) * std::cos(angle), radius * std::sin(height) * std::sin(angle),
          radius * std::cos(height)};
}

inline Surface theirs(const Meshd& mesh) {
  Surface surface;
  std::vector<Surface::Vertex_index> at;
  for (const Point3d& p : mesh.vertices) at.push_back(surface.add_vertex({p.x, p.y, p.z}));
  for (const Face& f : mesh.faces) surface.add_face(at[f.a], at[f.b], at[f.c]);
  return surface;
}

}  // namespace touchstone::bench
