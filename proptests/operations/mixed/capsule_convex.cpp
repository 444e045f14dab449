// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/capsule_convex.h"

#include "proptests/round_laws.h"
#include "proptests/solids.h"
#include "robust/mixed/capsule_aabb.h"

namespace touchstone::proptests::capsule_convex_tests {
namespace {

using Row = rows::capsule_convex;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;

using solids::mesh_of, solids::tetrahedron;
const Meshd cube = mesh_of({{-2, -2, -2}, {2, 2, 2}});
/// The edge from (0, 0, -9) to (0, 0, 9), behind x + y = 0.
const Meshd wedge = tetrahedron({0, 0, -9}, {0, 0, 18}, {-4, 0, 9}, {0, -4, 9});

constexpr Worked<Row> worked;

}  // namespace

ROUND_LAWS("capsule_convex")

ROBUST_LAW("capsule_convex: the box around the solid has the contact of capsule_aabb, and no less than the solid",
           capsule, mesh) {
  const Aabb3d box = solids::box_around(mesh);
  const Contact of_box = ask(Row::Question{capsule, mesh_of(box)});
  return of_box == robust::capsule_aabb(capsule, box) && of_box >= ask(asked);
}

TEST_CASE("capsule_convex: capsules beside a cube and an edge, worked by hand") {
  worked({{{{-9, 7, 0}, {9, 7, 0}}, 4}, cube}, disjoint, 9);  // along a face: 25 - 16
  worked({{{{-9, 7, 0}, {9, 7, 0}}, 6}, cube}, overlapping, 11);
  worked({{{{5, 6, 0}, {9, 9, 7}}, 5}, cube}, touching, 0);        // an end beyond an edge by (3, 4)
  worked({{{{10, 2, 5}, {2, 10, -5}}, 6}, cube}, overlapping, 4);  // across an edge by (4, 4): 36 - 32
  worked({{{{-9, 0, 0}, {9, 1, 1}}, 1}, cube}, overlapping, 1);    // through the cube
  worked({{{{0, 0, 0}, {1, 1, 1}}, 9}, cube}, overlapping, 81);    // within
  worked({{{{7, 1, 2}, {-1, 7, 2}}, 5}, wedge}, touching, 0);      // across the edge, beyond it by (3, 4)
}

TEST_CASE("capsule_convex: segments, points, huge, subnormal and negative zero") {
  worked({{{{-9, 0, 0}, {9, 1, 1}}, 0}, cube}, touching, 0, "rounding");
  worked({{{{3, 1, 2}, {1, 3, 2}}, -0.0}, cube}, touching, 0);  // through an edge's point (2, 2, 2)
  worked({{{{3, 2, 2}, {3, 2, 2}}, 0}, cube}, disjoint, 1);
  const Meshd least = mesh_of({{-tiny, -tiny, -tiny}, {tiny, tiny, tiny}});
  const Rational square = exact(tiny) * exact(tiny);
  worked({{{{2 * tiny, -0.0, 0}, {9, 0, 0}}, tiny}, least}, touching, 0);
  worked({{{{3 * tiny, 0, 0}, {9, 0, 0}}, tiny}, least}, disjoint, Rational(3 * square), "rounding");
  worked({{{{huge, 0, 0}, {huge, huge, 0}}, huge}, cube}, overlapping, Rational(4 * exact(huge) - 4), "rounding");
}

TEST_CASE("capsule_convex: numbers are refused first, then the radius, then the mesh") {
  Meshd open = cube;
  open.faces.pop_back();
  refused<Row>({{{{0, 0, 0}, {0, 0, infinity}}, -1}, open}, "capsule.segment[1][2]", "finite number");
  refused<Row>({{{{0, 0, 0}, {1, 0, 0}}, -1}, open}, "capsule.radius", "radius >= 0");
  refused<Row>({{{{0, 0, 0}, {1, 0, 0}}, 1}, open}, "mesh.faces[2]",
               "closed: edge 5 -> 7 must occur once, and 7 -> 5 once");
}

CONTRACT("capsule_convex: the formula in double says that solids are disjoint where its contract says so", capsule,
         mesh) {
  const auto& [a, b] = capsule.segment;
  return is_apart_from_mesh_where_certain(truth, answer, {{a, b}, {}, {}}, mesh, capsule.radius);
}

}  // namespace touchstone::proptests::capsule_convex_tests
