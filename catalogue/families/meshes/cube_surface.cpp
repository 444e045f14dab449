// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/meshes/cube_surface.h"

#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace touchstone::catalogue {
namespace {

/// The corners of a cell's square across an axis, counter-clockwise as seen from the greater side.
std::array<LatticePoint, 4> square(const LatticePoint& cell, std::size_t axis, std::int64_t side) {
  std::array<LatticePoint, 4> corners{cell, cell, cell, cell};
  for (LatticePoint& corner : corners) corner[axis] += side;
  for (const std::size_t k : {1, 2}) ++corners[k][(axis + 1) % 3];
  for (const std::size_t k : {2, 3}) ++corners[k][(axis + 2) % 3];
  return corners;
}

}  // namespace

Meshd cube_surface(const std::vector<LatticePoint>& cells) {
  const std::set<LatticePoint> taken(cells.begin(), cells.end());
  std::map<LatticePoint, Index> places;
  Meshd mesh;
  const auto vertex = [&](const LatticePoint& p) {
    const auto [found, added] = places.emplace(p, static_cast<Index>(mesh.vertices.size()));
    const auto coordinate = [](std::int64_t n) { return static_cast<double>(12 * n); };
    if (added) mesh.vertices.push_back({coordinate(p[0]), coordinate(p[1]), coordinate(p[2])});
    return found->second;
  };
  for (const LatticePoint& cell : taken) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const std::int64_t side : {0, 1}) {
        LatticePoint neighbour = cell;
        neighbour[axis] += 2 * side - 1;
        if (taken.contains(neighbour)) continue;
        auto corners = square(cell, axis, side);
        if (side == 0) std::swap(corners[1], corners[3]);
        std::array<Index, 4> at{};
        for (std::size_t k = 0; k < 4; ++k) at[k] = vertex(corners[k]);
        mesh.faces.push_back({at[0], at[1], at[2]});
        mesh.faces.push_back({at[0], at[2], at[3]});
      }
    }
  }
  return mesh;
}

}  // namespace touchstone::catalogue
