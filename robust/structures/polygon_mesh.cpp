// SPDX-License-Identifier: Apache-2.0
#include "robust/structures/polygon_mesh.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "geometry/validation.h"
#include "robust/kernel/solids/polygon_faces.h"

namespace touchstone::robust {

Meshd polygon_mesh(std::vector<Point3d> vertices, std::vector<std::vector<Index>> polygons) {
  Meshd mesh{std::move(vertices), {}, std::move(polygons)};
  validation::validate_numbers("mesh", mesh), mesh.polygon_rules(validation::Refusing{"mesh"});
  for (std::size_t i = 0; i < mesh.polygons.size(); ++i) {
    const std::vector<Index>& corners = mesh.polygons[i];
    if (corners.size() == 3) {
      mesh.faces.push_back({corners[0], corners[1], corners[2]});
      continue;
    }
    const auto cut = kernel::cut_polygon(mesh.vertices, corners);
    if (const auto* defect = std::get_if<kernel::PolygonDefect>(&cut)) {
      if (*defect == kernel::PolygonDefect::askew) validation::refuse_askew("mesh", i);
      validation::refuse_ring("mesh", i);
    }
    const auto& triangles = std::get<std::vector<Face>>(cut);
    mesh.faces.insert(mesh.faces.end(), triangles.begin(), triangles.end());
  }
  const auto triangle = [](const std::vector<Index>& corners) { return corners.size() == 3; };
  if (std::all_of(mesh.polygons.begin(), mesh.polygons.end(), triangle)) mesh.polygons.clear();
  return mesh;
}

ScaledRing::ScaledRing(const std::vector<Point3d>& vertices, const std::vector<Index>& ring) {
  double largest = 0;
  for (const Index v : ring)
    largest = std::max({largest, std::abs(vertices[v].x), std::abs(vertices[v].y), std::abs(vertices[v].z)});
  exponent = largest > 0 ? std::ilogb(largest) + 2 : 0;
  for (const Index v : ring) {
    const Point3d& p = vertices[v];
    corners.push_back({std::scalbn(p.x, -exponent), std::scalbn(p.y, -exponent), std::scalbn(p.z, -exponent)});
  }
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
    normal = normal + cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
}

double thickness(const std::vector<Point3d>& vertices, const std::vector<Index>& corners) {
  const ScaledRing ring(vertices, corners);
  const double length = std::hypot(ring.normal.x, ring.normal.y, ring.normal.z);
  if (length == 0) return 0;
  double least = 0, most = 0;
  for (const Point3d& p : ring.corners) {
    const double height = dot(ring.normal, p - ring.corners[0]) / length;
    least = std::min(least, height), most = std::max(most, height);
  }
  return std::scalbn(most - least, ring.exponent);
}

}  // namespace touchstone::robust
