// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/sphere_convex.h"

#include <utility>

#include "proptests/round_laws.h"
#include "proptests/solids.h"
#include "robust/mixed/penetration.h"
#include "robust/polyhedra/point_in_convex_polyhedron.h"

namespace touchstone::proptests::sphere_convex_tests {
namespace {

using Row = rows::sphere_convex;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;

using solids::mesh_of, solids::tetrahedron;
const Meshd cube = mesh_of({{-2, -2, -2}, {2, 2, 2}});
/// Its slanted face is x + 2 y + 2 z = 18.
const Meshd slanted = tetrahedron({0, 0, 0}, {18, 0, 0}, {0, 9, 0}, {0, 0, 9});
/// The edge from (0, 0, -9) to (0, 0, 9), behind x + y = 0.
const Meshd wedge = tetrahedron({0, 0, -9}, {0, 0, 18}, {-4, 0, 9}, {0, -4, 9});

constexpr Worked<Row> worked;

}  // namespace

ROUND_LAWS("sphere_convex")

ROBUST_LAW("sphere_convex: a point only touches the solid that it is in, and a ball around one overlaps it", ball,
           mesh) {
  return center_tells(ask, ball, mesh, robust::point_in_convex_polyhedron(mesh, ball.center));
}

ROBUST_LAW("sphere_convex: the box around the solid has the contact of sphere_aabb, and no less than the solid", ball,
           mesh) {
  const Aabb3d box = solids::box_around(mesh);
  const Contact of_box = ask(Row::Question{ball, mesh_of(box)});
  return of_box == robust::sphere_aabb(ball, box) && of_box >= ask(asked);
}

TEST_CASE("sphere_convex: balls beside a cube, a face and an edge, worked by hand") {
  balls_beside(cube, worked);
  worked({{{7, 5, 5}, 2}, slanted}, disjoint, 5);   // beyond a face by (1, 2, 2): 9 - 4
  worked({{{7, 5, 5}, 3}, slanted}, touching, 0);
  worked({{{7, 5, 5}, 4}, slanted}, overlapping, 7);
  worked({{{3, 4, 1}, 4}, wedge}, disjoint, 9);  // beyond an edge by (3, 4)
  worked({{{3, 4, 1}, 5}, wedge}, touching, 0);
  worked({{{-1, -1, 0}, 1}, wedge}, overlapping, 1);  // within
}

TEST_CASE("sphere_convex: points, huge, subnormal and negative zero") {
  worked({{{2, 2, 2}, 0}, cube}, touching, 0);  // its corner
  worked({{{1, 0, 0}, -0.0}, cube}, touching, 0);
  worked({{{3, 2, 2}, 0}, cube}, disjoint, 1);
  const Meshd least = mesh_of({{-tiny, -tiny, -tiny}, {tiny, tiny, tiny}});
  const Rational square = exact(tiny) * exact(tiny);
  worked({{{2 * tiny, -0.0, 0}, tiny}, least}, touching, 0);
  worked({{{3 * tiny, 0, 0}, tiny}, least}, disjoint, Rational(3 * square), "rounding");  // 4 - 1
  worked({{{0, 0, 0}, tiny}, least}, overlapping, square, "rounding");
  // The square of h less that of h - 2.
  worked({{{huge, 0, 0}, huge}, cube}, overlapping, Rational(4 * exact(huge) - 4), "rounding");
}

TEST_CASE("sphere_convex: a solid that ends in the center has the contact that penetration tells") {
  const Meshd behind = tetrahedron({3, 4, 1}, {9, 12, 0}, {8, 0, 1}, {0, 8, 1});
  for (const auto& [radius, contact] : {std::pair{4.0, disjoint}, {5.0, touching}, {6.0, overlapping}}) {
    CHECK(robust::sphere_convex({{3, 4, 1}, radius}, wedge) == contact);
    CHECK(robust::penetration(behind, wedge, radius, 0).contact == contact);
  }
}

TEST_CASE("sphere_convex: numbers are refused first, then the radius, then the mesh") {
  Meshd open = cube, endless = cube;
  open.faces.pop_back(), endless.vertices[0].x = infinity;
  refused<Row>({{{0, 0, 0}, -1}, endless}, "mesh.vertices[0][0]", "finite number");
  refused<Row>({{{0, 0, 0}, -1}, open}, "sphere.radius", "radius >= 0");
  refused<Row>({{{0, 0, 0}, 1}, open}, "mesh.faces[2]", "closed: edge 5 -> 7 must occur once, and 7 -> 5 once");
}

CONTRACT("sphere_convex: the formula in double says that solids are disjoint where its contract says so", ball, mesh) {
  return is_apart_from_mesh_where_certain(truth, answer, {{ball.center}, {}, {}}, mesh, ball.radius);
}

}  // namespace touchstone::proptests::sphere_convex_tests
