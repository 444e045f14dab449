// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/meshes/wrong_cuts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "catalogue/families/numbers.h"

namespace touchstone::catalogue {
namespace {

/// A polygon of a plane and triangles over its corners, and over other points of the plane.
struct CutPolygon {
  std::vector<Point2d> points;
  std::vector<Index> corners;
  std::vector<Face> triangles;
};

/// A strip that turns left three times and runs across its beginning. Each triangle has an area on its left, and
/// together they have the polygon's boundary; no corner lies in a triangle of which it is none.
const CutPolygon strip_across_itself{
    {{-2, 0}, {4, 0}, {4, 4}, {0, 4}, {0, -2}, {1, -2}, {1, 3}, {3, 3}, {3, 1}, {-2, 1}},
    {0, 1, 2, 3, 4, 5, 6, 7, 8, 9},
    {{0, 1, 8}, {0, 8, 9}, {1, 2, 7}, {1, 7, 8}, {2, 3, 6}, {2, 6, 7}, {3, 4, 5}, {3, 5, 6}}};

/// A square with a detour to a point within and back. The triangles meet in another point; the first one lies in or on
/// one of them.
CutPolygon square_with_a_detour(DrawStream& draws) {
  return {{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {one_to(draws, 3), 2}, {2, 1}},
          {0, 4, 0, 1, 2, 3},
          {{0, 1, 5}, {1, 2, 5}, {2, 3, 5}, {3, 0, 5}}};
}

/// The same detour between two vertices in one position, and triangles around its end: a valid cut.
const CutPolygon square_with_a_bridge{
    {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}, {0, 0}}, {0, 4, 5, 1, 2, 3}, {{5, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};

/// A square with two vertices in one corner, one after the other, and a triangle between these and the next.
const CutPolygon square_with_a_corner_twice{
    {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}, {0, 4, 1, 2, 3}, {{0, 4, 1}, {0, 1, 2}, {0, 2, 3}}};

/// A dart, and one triangle of it next to one across the corner that points inwards: together the hull of the dart.
const CutPolygon dart_as_its_hull{{{0, 0}, {4, 0}, {1, 1}, {0, 4}}, {0, 1, 2, 3}, {{0, 1, 2}, {1, 3, 2}}};

/// The square with a bridge, cut over the wrong one of the two vertices in one position.
const CutPolygon bridge_from_the_wrong_vertex{
    square_with_a_bridge.points, square_with_a_bridge.corners, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};

/// A triangle whose first side is walked forth, back and forth, and its cut from a point within, which is no corner.
const CutPolygon triangle_from_within{
    {{0, 0}, {4, 0}, {0, 4}, {1, 1}}, {0, 1, 0, 1, 2}, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};

/// In a plane across one of the axes, its triangles in any order and from any corner on.
Meshd with_one_more(Meshd mesh, CutPolygon more, DrawStream& draws) {
  const auto shift = static_cast<Index>(mesh.vertices.size());
  const std::uint64_t axis = draws.below(3);
  for (const Point2d& p : more.points) {
    const std::array<double, 3> at{p.x, p.y, -8};
    mesh.vertices.push_back({at[axis], at[(axis + 1) % 3], at[(axis + 2) % 3]});
  }
  for (Index& corner : more.corners) corner += shift;
  mesh.polygons.push_back(std::move(more.corners));
  const auto first = static_cast<std::ptrdiff_t>(draws.below(more.triangles.size()));
  std::rotate(more.triangles.begin(), more.triangles.begin() + first, more.triangles.end());
  for (const auto& [a, b, c] : more.triangles) {
    const std::array<Index, 3> ring{a + shift, b + shift, c + shift};
    const std::uint64_t k = draws.below(3);
    mesh.faces.push_back({ring[k], ring[(k + 1) % 3], ring[(k + 2) % 3]});
  }
  return mesh;
}

/// The triangle as far away in its plane as one of its sides 64 times.
void move_away(Meshd& mesh, Face& face) {
  const Vector3d displacement = 64.0 * (mesh.vertices[face.b] - mesh.vertices[face.a]);
  for (Index* corner : {&face.a, &face.b, &face.c}) {
    mesh.vertices.push_back(mesh.vertices[*corner] + displacement);
    *corner = static_cast<Index>(mesh.vertices.size() - 1);
  }
}

}  // namespace

Meshd with_wrong_cut(Meshd mesh, DrawStream& draws) {
  if (mesh.polygons.empty()) return mesh;
  Face& face = mesh.faces[draws.below(mesh.faces.size())];
  switch (draws.below(5)) {
    case 0: face = {face.b, face.c, face.a}; break;  // right, unless it is the whole polygon
    case 1: move_away(mesh, face); break;
    case 2:
      mesh.vertices.push_back(Point3d(mesh.vertices[face.a]));
      face.a = static_cast<Index>(mesh.vertices.size() - 1);
      break;
    case 3: std::swap(face.b, face.c); break;
    default: std::swap(face, mesh.faces[draws.below(mesh.faces.size())]);
  }
  return mesh;
}

Meshd with_wrong_polygon(Meshd mesh, DrawStream& draws) {
  if (mesh.polygons.empty()) return mesh;
  switch (draws.below(5)) {
    case 0: return with_one_more(std::move(mesh), {{{0, 0}, {4, 0}, {0, 4}}, {0, 1, 2}, {{0, 1, 2}}}, draws);
    case 1: return with_one_more(std::move(mesh), square_with_a_detour(draws), draws);
    case 2: return with_one_more(std::move(mesh), square_with_a_corner_twice, draws);
    case 3: return with_one_more(std::move(mesh), strip_across_itself, draws);
    default: return with_one_more(std::move(mesh), square_with_a_bridge, draws);
  }
}

Meshd with_foreign_cut(Meshd mesh, DrawStream& draws) {
  if (mesh.polygons.empty()) return mesh;
  switch (draws.below(3)) {
    case 0: return with_one_more(std::move(mesh), dart_as_its_hull, draws);
    case 1: return with_one_more(std::move(mesh), bridge_from_the_wrong_vertex, draws);
    default: return with_one_more(std::move(mesh), triangle_from_within, draws);
  }
}

Meshd with_lifted_corner(Meshd mesh, DrawStream& draws) {
  if (mesh.polygons.empty()) return mesh;
  const std::vector<Index>& corners = mesh.polygons[draws.below(mesh.polygons.size())];
  double& z = mesh.vertices[corners[draws.below(corners.size())]].z;
  z = ulps_apart(draws, z, 2);
  return mesh;
}

}  // namespace touchstone::catalogue
