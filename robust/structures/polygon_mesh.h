// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/invalid_input.h"
#include "geometry/polyhedra.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// A mesh given by polygons of three or more corners each, with a valid triangulation of each (the contract stands
/// above Mesh in geometry/polyhedra.h). If all have three corners, they are the faces, and `polygons` stays empty.
///
/// Throws InvalidInput for a coordinate that is not finite ("mesh.vertices[i][c]", "finite number"), fewer than three
/// corners ("mesh.faces[i]"), a corner that is not a vertex ("mesh.faces[i][k]", "index of a vertex"), corners that are
/// not coplanar ("mesh.faces[i]", "planar"), and a polygon that encloses no area or crosses or touches itself
/// ("mesh.faces[i]", "a polygon that encloses one area and does not cross itself"). Exact for all finite doubles.
Meshd polygon_mesh(std::vector<Point3d> vertices, std::vector<std::vector<Index>> polygons);

/// The corners of a polygon of finite vertices times 2^-exponent, each coordinate below 1/2 in size, and Newell's
/// normal of these, in double arithmetic.
struct ScaledRing {
  std::vector<Point3d> corners;
  int exponent = 0;
  Vector3d normal{0, 0, 0};

  ScaledRing(const std::vector<Point3d>& vertices, const std::vector<Index>& ring);
};

/// The distance of two planes perpendicular to the polygon's normal (Newell's) that enclose all corners; for a
/// quadrilateral that of the lines of its diagonals. In double arithmetic, for messages and tolerances; 0 if the normal
/// is 0.
double thickness(const std::vector<Point3d>& vertices, const std::vector<Index>& corners);

}  // namespace touchstone::robust
