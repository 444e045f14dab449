// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/polygons.h"
#include "geometry/space.h"

namespace touchstone {

/// Three places in a list of vertices, counter-clockwise as seen from outside.
struct Face {
  Index a, b, c;
  static constexpr auto members = as_list("a", "b", "c");
  friend bool operator==(const Face&, const Face&) = default;
};

/// Triangles over a list of vertices, as a surface in space. A face that names a vertex which is not there is refused.
///
/// A mesh may be named by polygons of three or more corners. `polygons` then holds them and `faces` a cut of them into
/// triangles: first those of polygon 0, two fewer than it has corners, then those of polygon 1, and so on
/// (robust/structures/polygon_mesh.h makes one). `polygons` is empty where every face is named as a triangle.
///
/// The corners of a polygon lie in one plane and name a ring that encloses an area. Corners may lie on the edge between
/// two others, and the ring may run along one bridge in both directions, as around a hole. It may return to a position,
/// but not cross itself, nor touch one of its edges but in a corner. A cut is valid if it covers that area: its
/// triangles are over corners of the polygon and have areas, all turned as the polygon is, no interior point in common,
/// and no corner of it but their own. Every valid cut gives the same answers. A polygon that is a triangle is its own
/// cut, with its corners in the same order. Where two corners name different vertices in one position, as two sides of
/// a bridge may, each triangle names the one on its own side.
template <class Real>
struct Mesh {
  std::vector<Point3<Real>> vertices;
  std::vector<Face> faces;
  std::vector<std::vector<Index>> polygons;
  static constexpr auto members = Members<3>{Form::mesh, {"vertices", "faces", "polygons"}};

  /// Corners name vertices, and there are as many triangles as a cut of the polygons has. Rules that take arithmetic
  /// are in geometry/validation.h.
  bool rules(const auto& check) const {
    if (!polygon_rules(check)) return false;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Index corners[]{faces[i].a, faces[i].b, faces[i].c};
      if (!names_vertices({polygons.empty() ? "faces" : "cut", i}, corners, 3, check)) return false;
    }
    std::size_t triangles = 0;
    for (const auto& polygon : polygons) triangles += polygon.size() - 2;
    return check("cut", {polygons.empty() || triangles == faces.size(), cut_of_faces.words});
  }
  bool polygon_rules(const auto& check) const {
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      const auto& corners = polygons[i];
      if (!check({"faces", i}, {corners.size() >= 3, "at least 3 corners"})) return false;
      if (!names_vertices({"faces", i}, corners.data(), corners.size(), check)) return false;
    }
    return true;
  }
  bool names_vertices(const Where& face, const Index* corners, std::size_t count, const auto& check) const {
    for (std::size_t k = 0; k < count; ++k)
      if (!check({face.name, face.i, k}, {corners[k] < vertices.size(), "index of a vertex"})) return false;
    return true;
  }
  static constexpr rule::Exact cut_of_faces{"cut", "a cut of the faces into triangles"};
};

using Meshd = Mesh<double>;

/// The count of faces that a mesh names.
template <class Real>
std::size_t named_faces(const Mesh<Real>& mesh) {
  return mesh.polygons.empty() ? mesh.faces.size() : mesh.polygons.size();
}

/// For each triangle, the named face of which it is a part.
template <class Real>
std::vector<Index> named_face_of_each(const Mesh<Real>& mesh) {
  std::vector<Index> named;
  named.reserve(mesh.faces.size());
  if (mesh.polygons.empty()) {
    for (Index i = 0; i < mesh.faces.size(); ++i) named.push_back(i);
  }
  for (Index i = 0; i < mesh.polygons.size(); ++i) named.insert(named.end(), mesh.polygons[i].size() - 2, i);
  return named;
}

/// The named face of which one triangle is a part.
template <class Real>
Index named_face_of(const Mesh<Real>& mesh, Index triangle) {
  if (mesh.polygons.empty()) return triangle;
  Index i = 0;
  for (std::size_t left = triangle; left >= mesh.polygons[i].size() - 2; ++i) left -= mesh.polygons[i].size() - 2;
  return i;
}

/// The corners of the named face of that number.
template <class Real>
std::vector<Index> corners_of_named(const Mesh<Real>& mesh, std::size_t face) {
  if (!mesh.polygons.empty()) return mesh.polygons[face];
  return {mesh.faces[face].a, mesh.faces[face].b, mesh.faces[face].c};
}

}  // namespace touchstone
