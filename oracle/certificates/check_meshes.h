// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "oracle/certificates/check_space.h"

/// Shared by the checks of polyhedra.
namespace touchstone::certify {

/// Triangles over vertices, each three indices in that list; the named faces, of three or more corners each, and for
/// each triangle the face that contains it.
struct Mesh {
  std::vector<Triple> vertices;
  std::vector<std::array<std::size_t, 3>> faces;
  std::vector<std::vector<std::size_t>> named;
  std::vector<std::size_t> face_of;
};

/// Input, by the field's name: every face uses valid vertices, and there are at least 4 faces. If each has three
/// corners, these are different, and the faces are the triangles. Otherwise `cut` has the triangles, face by face, and
/// they are a valid triangulation, by check_polygon_faces.cpp.
Mesh mesh(const json& value, const std::string& what);

/// The same of any faces: no number of them is too small, and one of three corners may use a vertex twice.
Mesh listed_faces(const json& value, const std::string& what);

/// The place of a point of a named face in it.
const char* part_of(const Mesh& mesh, std::size_t face, const Triple& x);

/// Requires that the faces of the mesh are planar, and that its triangles are a valid triangulation of them.
void expect_cut(const Mesh& mesh, const std::string& what);

/// Requires that the mesh is closed and convex: every edge of a face is in one other face, in the opposite direction;
/// every face has an area; its plane has a vertex outside it, and all such vertices lie on one side, which is the same
/// one, relative to the faces' orientation, for all faces. (reference/polyhedra/point_in_convex_polyhedron.h explains
/// why the solid is then the one that these planes enclose.) Returns the faces' planes, positive outside. Takes faces
/// times vertices steps.
std::vector<Plane> outward_planes(const Mesh& mesh, const std::string& what);

/// The t > 0 at which the ray along `direction` crosses a face, whose corners are relative to the point; nullopt if it
/// does not. Requires that its line misses every edge: it passes on one side of it, by the sign of a volume; or the
/// edge lies on a line through the point, which is not between its ends, and the direction differs. So the face,
/// whether it has an area or not, is crossed if the line passes all its edges on one side, and if not, it does not
/// contain the point either.
std::optional<Rational> crossing(const std::array<Triple, 3>& corners, const Triple& direction);

}  // namespace touchstone::certify
