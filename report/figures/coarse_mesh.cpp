// SPDX-License-Identifier: Apache-2.0
#include "report/figures/coarse_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace touchstone::report {
namespace {

using Corners = std::vector<Index>;
using GridCell = std::array<int, 3>;
constexpr std::array<double Point3d::*, 3> axes{&Point3d::x, &Point3d::y, &Point3d::z};
constexpr std::size_t most_grid_cells = 512;

/// The first vertices of the faces that are least and greatest along each axis.
std::array<std::array<Index, 2>, 3> extremes_of(const MeshFile& mesh) {
  std::array<std::array<Index, 2>, 3> found;
  for (auto& ends : found) ends.fill(mesh.faces[0][0]);
  for (const Corners& corners : mesh.faces) {
    for (const Index v : corners) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (mesh.vertices[v].*axes[k] < mesh.vertices[found[k][0]].*axes[k]) found[k][0] = v;
        if (mesh.vertices[v].*axes[k] > mesh.vertices[found[k][1]].*axes[k]) found[k][1] = v;
      }
    }
  }
  return found;
}

std::size_t corners_of(const std::vector<Corners>& faces) {
  std::size_t count = 0;
  for (const Corners& corners : faces) count += corners.size();
  return count;
}

/// Rotates the corners so that the least comes first.
Corners from_least(Corners corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// Maps the corners of faces to the first vertices in their cells.
std::vector<Corners> faces_of_cells(const MeshFile& mesh, const std::array<std::array<Index, 2>, 3>& extremes,
                                    std::size_t cells) {
  const auto cell_of = [&](const Point3d& p) {
    GridCell cell{};
    for (std::size_t k = 0; k < 3; ++k) {
      // Halved, so that a difference is finite.
      const double low = mesh.vertices[extremes[k][0]].*axes[k] / 2, high = mesh.vertices[extremes[k][1]].*axes[k] / 2;
      const double part = high > low ? (p.*axes[k] / 2 - low) / (high - low) : 0;
      cell[k] = static_cast<int>(std::min(part * static_cast<double>(cells), static_cast<double>(cells) - 1));
    }
    return cell;
  };
  std::map<GridCell, Index> first;
  std::vector<Corners> faces;
  std::set<Corners> known;
  for (const Corners& corners : mesh.faces) {
    Corners kept;
    for (const Index v : corners) {
      const Index shown = first.try_emplace(cell_of(mesh.vertices[v]), v).first->second;
      if (kept.empty() || kept.back() != shown) kept.push_back(shown);
    }
    while (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
    if (kept.size() < 3) continue;
    kept = from_least(std::move(kept));
    if (known.insert(kept).second) faces.push_back(std::move(kept));
  }
  return faces;
}

}  // namespace

CoarseMesh coarse_mesh(const MeshFile& mesh, std::size_t most_corners) {
  CoarseMesh coarse;
  if (mesh.faces.empty()) return coarse;
  const auto extremes = extremes_of(mesh);
  std::vector<Corners> faces;
  if (corners_of(mesh.faces) <= most_corners) {
    faces = mesh.faces;
  } else {
    coarse.cells = most_grid_cells;
    while (corners_of(faces = faces_of_cells(mesh, extremes, coarse.cells)) > most_corners) coarse.cells /= 2;
  }
  std::map<Index, Index> place;
  const auto add = [&](Index v) {
    const auto [at, fresh] = place.emplace(v, static_cast<Index>(place.size()));
    if (fresh) coarse.vertices.push_back(mesh.vertices[v]);
    return at->second;
  };
  for (const Corners& corners : faces) {
    Corners& shown = coarse.faces.emplace_back();
    for (const Index v : corners) shown.push_back(add(v));
  }
  for (const auto& ends : extremes)
    for (const Index v : ends) add(v);
  return coarse;
}

}  // namespace touchstone::report
