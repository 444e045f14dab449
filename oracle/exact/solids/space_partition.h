// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/answers.h"
#include "oracle/exact/solids/solid.h"
#include "oracle/exact/solids/triangles.h"

namespace touchstone::oracle {

/// A partition of space, by planes into convex cells, each of which is outside of one of two solids.
///
/// A cell that no face of a solid enters is inside or outside of it as one of its points is. Other cells are cut: by a
/// plane between their faces of one solid and those of the other where there is one, otherwise by the best of some
/// planes near them. Cells are closed, for solids without a common point: a face enters a cell that it only touches,
/// and each plane keeps apart two faces that touched one cell. Or they are open, for solids whose interiors have no
/// common point: a face enters a cell if a point strictly within is on it, and a plane that holds it ends that. Faces
/// without area do not count there. If the solids have such a point after all, the cutting ends with it.
struct SpacePartition {
  enum class Cells { closed, open };
  /// The location of a point in a solid, 0 or 1. Each cell of the partition has one point that is outside.
  using Locate = std::function<Location(std::size_t solid, const Point3<Rational>& point)>;
  SpacePartition(const std::array<const Solid*, 2>& solids, Cells cells, const Locate& locate);

  /// If there is no partition: a point of both solids, strictly inside of both if cells are open.
  std::optional<Point3<Rational>> common;

  /// A cut, and then the cells in front of it, and then those behind it; or the solid that the cell is outside of.
  static constexpr int cut = 2;
  std::vector<int> tree;
  std::vector<WitnessPlane> planes;      ///< of the cuts, in their order in the tree
  std::vector<Point3<Rational>> points;  ///< strictly within each cell, in their order in the tree
};

}  // namespace touchstone::oracle
