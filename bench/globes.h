// SPDX-License-Identifier: Apache-2.0
#pragma once

// CGAL as peer: meshes as its algorithms take them.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "geometry/polyhedra.h"

/// Closed meshes of many faces.
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

/// A sphere; a sphere with bumps; and the sphere's points moved out to a cube, with faces that are flat and oblique up
/// to rounding.
inline Meshd mesh_of(const std::string& set, Index n) {
  return globe(n, [&set](double height, double angle) {
    if (set == "bumps") return on_sphere(height, angle, 1 + 0.2 * std::sin(7 * height) * std::sin(5 * angle));
    const Point3d p = on_sphere(height, angle, 1);
    if (set == "sphere") return p;
    const double size = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    const Point3d q{p.x / size, p.y / size, p.z / size};
    return Point3d{0.6 * q.x - 0.8 * q.y, 0.28 * (0.8 * q.x + 0.6 * q.y) - 0.96 * q.z,
                   0.96 * (0.8 * q.x + 0.6 * q.y) + 0.28 * q.z};
  });
}

inline constexpr const char* sets[] = {"sphere", "bumps", "turned_cube"};

/// About how many faces a globe has, and its n.
struct Size {
  std::size_t faces;
  Index n;
};
inline constexpr Size sizes[] = {{1000, 16}, {10000, 50}, {100000, 158}, {1000000, 500}};

inline Surface theirs(const Meshd& mesh) {
  Surface surface;
  std::vector<Surface::Vertex_index> at;
  for (const Point3d& p : mesh.vertices) at.push_back(surface.add_vertex({p.x, p.y, p.z}));
  for (const Face& f : mesh.faces) surface.add_face(at[f.a], at[f.b], at[f.c]);
  return surface;
}

}  // namespace touchstone::bench
