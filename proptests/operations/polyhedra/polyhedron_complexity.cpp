// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/polyhedra/polyhedron_complexity.h"

#include <algorithm>

#include "catalogue/families/cube_surface.h"
#include "proptests/space_laws.h"

namespace touchstone::proptests::polyhedron_complexity_tests {
namespace {

using Row = rows::polyhedron_complexity;
using catalogue::cube_surface;

const Meshd four{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {-4, 0, 0}, {0, -4, 0}, {0, 0, -4}},
                 {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};

Meshd with_faces(Meshd mesh, const std::vector<Face>& more) {
  mesh.faces.insert(mesh.faces.end(), more.begin(), more.end());
  return mesh;
}

/// The words, in the order of the answer.
struct Said {
  bool closed, oriented, edge_manifold, vertex_manifold;
};
void worked(const Meshd& mesh, Index vertices, Index edges, Index components, const Said& said,
            const std::string& by_reference = "agree") {
  const auto faces = static_cast<Index>(mesh.faces.size());
  const int euler = static_cast<int>(vertices) - static_cast<int>(edges) + static_cast<int>(faces);
  example<Row>({mesh},
               {vertices, edges, faces, components, Rational(euler), said.closed, said.oriented, said.edge_manifold,
                said.vertex_manifold},
               by_reference);
}

}  // namespace

LAW("polyhedron_complexity: it does not matter in which order faces and vertices are listed", mesh) {
  const auto found = ask(asked);
  Meshd other = mesh;
  std::reverse(other.faces.begin(), other.faces.end());
  const auto last = static_cast<Index>(mesh.vertices.size() - 1);
  for (Face& f : other.faces) f = {last - f.b, last - f.c, last - f.a};
  std::reverse(other.vertices.begin(), other.vertices.end());
  return ask(Row::Question{other}) == found;
}

LAW("polyhedron_complexity: turned inside out, and with its vertices elsewhere, a mesh is the same", mesh) {
  Meshd other = mesh;
  for (Face& f : other.faces) std::swap(f.a, f.b);
  for (Point3d& p : other.vertices) p = {0, 0, 0};
  return ask(Row::Question{other}) == ask(asked);
}

LAW("polyhedron_complexity: two copies have twice of everything, and the words of one", mesh) {
  auto found = ask(asked);
  Meshd both = mesh;
  const auto shift = static_cast<Index>(mesh.vertices.size());
  both.vertices.insert(both.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
  for (const Face& f : mesh.faces) both.faces.push_back({f.a + shift, f.b + shift, f.c + shift});
  found.vertices *= 2, found.edges *= 2, found.faces *= 2, found.components *= 2, found.euler += found.euler;
  return ask(Row::Question{both}) == found;
}

TEST_CASE("polyhedron_complexity: p. 26's formula of Euler, of solids with handles, hollows and several parts") {
  const Said surface{true, true, true, true};
  worked(four, 4, 6, 1, surface);                        // 2; vertices of no face are none
  worked(cube_surface({{0, 0, 0}}), 8, 18, 1, surface);  // 8 - 18 + 12 = 2
  worked(cube_surface({{0, 0, 0}, {2, 0, 0}}), 16, 36, 2, surface);
  // A ring of eight cubes: 4 x 4 points in two layers, all on the surface; four sides of 8 squares: 32 - 96 + 64 = 0.
  worked(cube_surface({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}}), 32, 96,
         1, surface);
}

TEST_CASE("polyhedron_complexity: what is no surface, and where") {
  worked(with_faces(four, {{0, 5, 4}, {0, 4, 6}, {0, 6, 5}, {4, 5, 6}}), 7, 12, 1, {true, true, true, false},
         "algorithm");  // a vertex in common: 7 - 12 + 8 = 3
  worked(with_faces(four, {{0, 5, 1}, {0, 1, 4}, {0, 4, 5}, {1, 5, 4}}), 6, 11, 1, {true, true, false, false});
  worked(with_faces(four, {{4, 5, 6}}), 7, 9, 2, {false, true, true, true});
  worked(with_faces(four, {{1, 2, 4}}), 5, 8, 1, {false, true, false, false});
  worked(with_faces(four, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}), 4, 6, 1, {true, true, false, false});
  Meshd turned = four;
  std::swap(turned.faces[3].a, turned.faces[3].b);
  worked(turned, 4, 6, 1, {true, false, true, true});
}

TEST_CASE("polyhedron_complexity: meshes are refused by the first rule that they break") {
  const auto faces = [](const std::vector<Face>& list) { return Row::Question{Meshd{four.vertices, list}}; };
  Meshd infinite = four;
  infinite.vertices[1].z = infinity;
  infinite.faces[0].a = 9;
  refused<Row>({infinite}, "mesh.vertices[1][2]", "finite number");
  refused<Row>(faces({{0, 2, 2}, {0, 1, 7}}), "mesh.faces[1][2]", "index of a vertex");
  refused<Row>(faces({{0, 2, 1}, {2, 0, 2}}), "mesh.faces[1]", "three different vertices");
  refused<Row>(faces({{0, 2, 1}, {0, 1, 3}, {0, 3, 2}}), "mesh", "at least 4 faces");
}

}  // namespace touchstone::proptests::polyhedron_complexity_tests
