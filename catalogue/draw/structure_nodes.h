// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "catalogue/draw/convex_cells.h"
#include "catalogue/draw/drawing.h"
#include "catalogue/draw/figures.h"
#include "reference/broad_phase/bounding_volume_hierarchy.h"
#include "reference/broad_phase/bsp_tree.h"
#include "reference/broad_phase/quadtree.h"
#include "reference/broad_phase/sphere_hierarchy.h"
#include "reference/broad_phase/uniform_grid.h"

/// The nodes of the textbook structures, as figures in space.
namespace touchstone::catalogue {

/// A node by its address, by which a search reports that it passes it.
struct StructureNode {
  const void* node;
  int depth;
  SpaceFigure figure;  ///< without numbers if the node has no extent to draw
};
using StructureNodes = std::vector<StructureNode>;

inline SpaceFigure volume_figure(const Aabb3d& box) {
  return {SpaceFigure::Kind::box, "", coordinates_of({box.min, box.max}), {}};
}
inline SpaceFigure volume_figure(const Sphere3d& ball) {
  return {SpaceFigure::Kind::sphere, "", {ball.center.x, ball.center.y, ball.center.z, ball.radius}, {}};
}

/// Trees of volumes.
template <class Tree>
void add_nodes(StructureNodes& nodes, const Tree& tree, int depth) {
  nodes.push_back({&tree, depth, volume_figure(tree.volume())});
  for (const Tree& child : tree.children()) add_nodes(nodes, child, depth + 1);
}

/// A node of a tree of planes is its part of space within the box of the first six half-spaces. A node that is split is
/// drawn as the cut alone, a leaf as the faces of its part.
inline void add_nodes(StructureNodes& nodes, const ::touchstone::reference::PlaneTree<double>& tree, int depth,
                      const std::vector<HalfSpace>& half_spaces) {
  SpaceFigure figure;
  if (tree.parts().empty()) {
    figure.kind = SpaceFigure::Kind::mesh;
    for (const auto& corners : faces_of_cell(half_spaces)) {
      auto first = static_cast<std::uint32_t>(figure.numbers.size() / 3);
      std::vector<std::uint32_t>& face = figure.faces.emplace_back();
      for (const double x : coordinates_of(corners)) figure.numbers.push_back(x);
      while (face.size() < corners.size()) face.push_back(first++);
    }
    nodes.push_back({&tree, depth, std::move(figure)});
    return;
  }
  const auto& [normal, offset] = tree.plane();
  figure.kind = SpaceFigure::Kind::polygon;
  figure.numbers = coordinates_of(part_of_plane(tree.plane(), half_spaces));
  nodes.push_back({&tree, depth, std::move(figure)});
  const HalfSpace sides[] = {{normal, offset}, {{-normal.x, -normal.y, -normal.z}, -offset}};
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<HalfSpace> more = half_spaces;
    more.push_back(sides[i]);
    add_nodes(nodes, tree.parts()[i], depth + 1, more);
  }
}

/// All nodes of a structure over at least one body, within the box around all bodies.
template <class Structure>
StructureNodes nodes_of(const Structure& structure, const Aabb3d&) {
  StructureNodes nodes;
  add_nodes(nodes, structure, 0);
  return nodes;
}
inline StructureNodes nodes_of(const ::touchstone::reference::PlaneTree<double>& tree, const Aabb3d& all) {
  StructureNodes nodes;
  add_nodes(nodes, tree, 0, half_spaces_of(all));
  return nodes;
}
inline StructureNodes nodes_of(const ::touchstone::reference::Grid<double>& grid, const Aabb3d&) {
  StructureNodes nodes;
  for (const auto& cell : grid.cells()) nodes.push_back({&cell, 0, volume_figure(cell.box)});
  return nodes;
}

}  // namespace touchstone::catalogue
