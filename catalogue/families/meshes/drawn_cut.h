// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "catalogue/families/draw_stream.h"
#include "geometry/polyhedra.h"
#include "oracle/exact/shapes/whole_cloud.h"

namespace touchstone::catalogue {

/// Polygons over a list of vertices, cut without robust, so that a polygon that robust wrongly refuses is asked all the
/// same.
class PolygonCutter {
 public:
  explicit PolygonCutter(const std::vector<Point3d>& vertices) : cloud_(vertices) {}

  /// One of the valid cuts of a polygon (geometry/polyhedra.h), drawn; empty where it has none. Its corners are
  /// vertices, three or more.
  std::optional<std::vector<Face>> cut(const std::vector<Index>& corners, DrawStream& draws) const;

 private:
  oracle::IntegerCloud cloud_;
};

/// A mesh named by polygons, which are valid or of three corners, each with one of its valid cuts, drawn.
Meshd cut_mesh(std::vector<Point3d> vertices, std::vector<std::vector<Index>> polygons, DrawStream& draws);

}  // namespace touchstone::catalogue
