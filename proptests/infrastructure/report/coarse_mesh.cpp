// SPDX-License-Identifier: Apache-2.0
#include "report/figures/coarse_mesh.h"

#include <algorithm>

#include "proptests/catch.h"
#include "proptests/uses.h"

/// Meshes as pages draw them.
namespace touchstone::proptests::coarse_mesh_tests {
namespace {

/// Squares in the plane z = 0, from 0 to `side` along x and y, all seen from above.
audit::MeshFile squares(Index side) {
  audit::MeshFile mesh;
  for (Index j = 0; j <= side; ++j)
    for (Index i = 0; i <= side; ++i) mesh.vertices.push_back({static_cast<double>(i), static_cast<double>(j), 0});
  const Index row = side + 1;
  for (Index j = 0; j < side; ++j)
    for (Index i = 0; i < side; ++i)
      mesh.faces.push_back({j * row + i, j * row + i + 1, (j + 1) * row + i + 1, (j + 1) * row + i});
  return mesh;
}

/// Twice the area of a triangle as seen from above.
double orientation_of(const Point3d& p, const Point3d& q, const Point3d& r) {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

}  // namespace

TEST_CASE("coarse_mesh: a mesh with few corners is drawn as it is") {
  const audit::MeshFile mesh = squares(10);
  const report::CoarseMesh drawn = report::coarse_mesh(mesh, 400);
  CHECK(drawn.cells == 0);
  CHECK(drawn.faces.size() == 100);
  CHECK(drawn.vertices.size() == 121);
  CHECK(report::coarse_mesh({}, 400).faces.empty());
}

TEST_CASE("coarse_mesh: a mesh with more is drawn all over, with as many cells as there is room for") {
  // 100 squares in a row: 64 cells in a row leave 63 squares or more and 64 at most, 128 cells leave all 100.
  const report::CoarseMesh drawn = report::coarse_mesh(squares(100), 18000);
  CHECK(drawn.cells == 64);
  CHECK(drawn.faces.size() >= 63 * 63);
  CHECK(drawn.faces.size() <= 64 * 64);
  double area = 0, most_x = 0, most_y = 0;
  for (const auto& corners : drawn.faces) {
    const Point3d &p = drawn.vertices[corners[0]], &q = drawn.vertices[corners[1]], &r = drawn.vertices[corners[2]];
    CHECK(orientation_of(p, q, r) > 0);
    for (std::size_t k = 2; k < corners.size(); ++k)
      area += orientation_of(p, drawn.vertices[corners[k - 1]], drawn.vertices[corners[k]]) / 2;
  }
  CHECK(area >= 98.0 * 98.0);  // a cell is narrower than two squares
  for (const Point3d& p : drawn.vertices) most_x = std::max(most_x, p.x), most_y = std::max(most_y, p.y);
  CHECK(most_x == 100);
  CHECK(most_y == 100);
}

}  // namespace touchstone::proptests::coarse_mesh_tests
