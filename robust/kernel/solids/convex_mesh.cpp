// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/solids/convex_mesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/validation.h"
#include "robust/kernel/shapes/face_side.h"
#include "robust/kernel/shapes/plane.h"
#include "robust/kernel/solids/polygon_faces.h"

namespace touchstone::robust::kernel {
namespace {

std::array<Index, 4> ring_of(const Face& face) { return {face.a, face.b, face.c, face.a}; }

std::uint64_t edge(Index from, Index to) { return std::uint64_t{from} << 32 | to; }

void validate_closed(const std::string& field, const Meshd& mesh) {
  std::vector<std::uint64_t> edges;
  edges.reserve(3 * mesh.faces.size());
  for (const Face& face : mesh.faces) {
    const auto ring = ring_of(face);
    for (std::size_t k = 0; k < 3; ++k) edges.push_back(edge(ring[k], ring[k + 1]));
  }
  std::sort(edges.begin(), edges.end());
  const auto once = [&edges](Index from, Index to) {
    const auto [first, last] = std::equal_range(edges.begin(), edges.end(), edge(from, to));
    return last - first == 1;
  };
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const auto ring = ring_of(mesh.faces[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      if (!once(ring[k], ring[k + 1]) || !once(ring[k + 1], ring[k]))
        validation::refuse_edge(field, mesh, i, ring[k], ring[k + 1]);
    }
  }
}

bool has_area(const Meshd& mesh, const Face& face) {
  const Point3d &a = mesh.vertices[face.a], &b = mesh.vertices[face.b], &c = mesh.vertices[face.c];
  const auto n = integers_of(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z).at;
  const auto zero = [&n](std::size_t x, std::size_t y) {
    return sgn(mpz_class((n[3 + x] - n[x]) * (n[6 + y] - n[y]) - (n[3 + y] - n[y]) * (n[6 + x] - n[x]))) == 0;
  };
  return !(zero(0, 1) && zero(1, 2) && zero(2, 0));
}

void validate_areas(const std::string& field, const Meshd& mesh) {
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    if (!has_area(mesh, mesh.faces[i])) validation::refuse_area(field, mesh, i);
  }
}

}  // namespace

int validate_convex(const std::string& field, const Meshd& mesh, Stage& latest) {
  validation::validate(field, mesh), validate_polygons(field, mesh);
  validation::validate_triangles(field, mesh), validate_closed(field, mesh);
  int outside = 0;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const Face& face = mesh.faces[i];
    const FaceSide plane(mesh, face);
    bool off = false;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      if (v == face.a || v == face.b || v == face.c) continue;
      const int side = plane.of(mesh.vertices[v]).noting(latest);
      if (side == 0) continue;
      off = true;
      if (outside == 0) outside = -side;
      if (side == outside) validate_areas(field, mesh), validation::refuse_beyond(field, mesh, i, v);
    }
    // If the mesh has no area no vertex is off the plane; if face 0 has one, a vertex is off, and with it one for every
    // face that has an area.
    if (!off) validate_areas(field, mesh), validation::refuse_flat_mesh(field);
  }
  return outside;
}

}  // namespace touchstone::robust::kernel
