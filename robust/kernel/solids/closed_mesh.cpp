// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/solids/closed_mesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/closed_mesh.h"
#include "robust/kernel/solids/polygon_faces.h"

namespace touchstone::robust::kernel {
namespace {

std::uint64_t edge(Index from, Index to) { return std::uint64_t{std::min(from, to)} << 32 | std::max(from, to); }

std::array<Index, 4> ring_of(const Face& face) { return {face.a, face.b, face.c, face.a}; }

/// In ascending order without duplicates. Edges are grouped by their lesser vertices.
std::vector<std::uint64_t> edges_of_odd_number(const Meshd& mesh) {
  std::vector<std::size_t> end(mesh.vertices.size() + 1);
  const auto for_each_edge = [&mesh](const auto& take) {
    for (const Face& face : mesh.faces) {
      const auto ring = ring_of(face);
      for (std::size_t k = 0; k < 3; ++k) take(std::min(ring[k], ring[k + 1]), std::max(ring[k], ring[k + 1]));
    }
  };
  for_each_edge([&end](Index from, Index) { ++end[from + 1]; });
  for (std::size_t v = 1; v < end.size(); ++v) end[v] += end[v - 1];
  std::vector<Index> ends(3 * mesh.faces.size());
  for_each_edge([&](Index from, Index to) { ends[end[from]++] = to; });
  std::vector<std::uint64_t> odd;
  std::vector<std::uint8_t> uses(mesh.vertices.size());  // of the edge to each vertex, modulo 2
  auto first = ends.begin();
  for (Index from = 0; from < mesh.vertices.size(); ++from) {
    const auto last = ends.begin() + static_cast<std::ptrdiff_t>(end[from]);
    int edges = 0;
    for (auto to = first; to != last; ++to) edges += (uses[*to] ^= 1) != 0 ? 1 : -1;
    if (edges != 0) {
      std::sort(first, last);
      for (auto to = first; to != last; ++to)
        if (uses[*to] != 0) odd.push_back(edge(from, *to)), uses[*to] = 0;
    }
    first = last;
  }
  return odd;
}

}  // namespace

void validate_closed(const std::string& field, const Meshd& mesh) {
  mesh.rules(validation::Refusing{field}), validate_polygons(field, mesh);
  validation::validate_triangles(field, mesh);
  const auto odd = edges_of_odd_number(mesh);
  if (odd.empty()) return;
  std::size_t triangle = 0;
  for (std::size_t i = 0; i < named_faces(mesh); ++i) {
    const std::vector<Index> corners = corners_of_named(mesh, i);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Index from = corners[k], to = corners[(k + 1) % corners.size()];
      if (std::binary_search(odd.begin(), odd.end(), edge(from, to)))
        validation::refuse_odd_edge(field, mesh, triangle, from, to);
    }
    triangle += corners.size() - 2;
  }
}

}  // namespace touchstone::robust::kernel
