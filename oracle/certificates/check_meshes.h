// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "oracle/certificates/check_space.h"

/// What the checks of polyhedra share.
namespace touchstone::certify {

/// Triangles over vertices, each three places in that list; the faces as they are named, of three or more corners each,
/// and of each triangle the face that it is a part of.
struct Mesh {
  std::vector<Triple> vertices;
  std::vector<std::array<std::size_t, 3>> faces;
  std::vector<std::vector<std::size_t>> named;
  std::vector<std::size_t> face_of;
};

/// Input, by the field's name: every face names vertices, and there are at least 4 faces. Where each has three corners,
/// these are different, and the faces are the triangles. Otherwise `cut` has the triangles, face by face, and they are
/// a valid cut, by check_polygon_faces.cpp.
Mesh mesh(const json& value, const std::string& what);

/// The faces of the mesh are planar, and its triangles are a valid cut of them.
void expect_cut(const Mesh& mesh, const std::string& what);

/// The mesh is closed and convex: every edge of a face is in one other face, in the opposite direction; every face has
/// an area; its plane has a vertex beside it, and all such vertices lie on one side, which is the same one, as the
/// faces turn, for all faces. (Why the solid is then what these planes enclose stands in
/// reference/polyhedra/point_in_convex_polyhedron.h.) Returns the faces' planes, positive outside. Takes faces times
/// vertices steps.
std::vector<Plane> outward_planes(const Mesh& mesh, const std::string& what);

/// Where the ray along `direction` crosses a face, whose corners are given as the point sees them: at t > 0, or not at
/// all. Its line misses every edge: it passes beside it, which the sign of a volume tells; or the edge lies on a line
/// through the point, which is not between its ends, and the direction is another. So the face, whether it has an area
/// or not, is crossed if the line passes all its edges on one side, and if not, it does not hold the point either.
std::optional<Rational> crossing(const std::array<Triple, 3>& corners, const Triple& direction);

}  // namespace touchstone::certify
