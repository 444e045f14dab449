// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/polygons/triangulate_polygon.h"

#include "proptests/partition_laws.h"

namespace touchstone::proptests::triangulate_polygon_tests {

using Row = rows::triangulate_polygon;

PARTITION_LAWS("triangulate_polygon", "triangles")

LAW("triangulate_polygon: n - 2 triangles, and every vertex is a corner") {
  const std::size_t n = opened(std::get<0>(asked)).size();
  std::set<Index> corners;
  const IndexLists triangles = ask(asked);
  for (const auto& triangle : triangles) {
    if (triangle.size() != 3) return false;
    corners.insert(triangle.begin(), triangle.end());
  }
  return triangles.size() == n - 2 && corners.size() == n;
}

TEST_CASE("triangulate_polygon: rings with one triangulation, worked by hand") {
  only_answer<Row>({{{0, 0}, {1, 0}, {0, 1}}}, {{0, 1, 2}});
  only_answer<Row>({{{0, 1}, {1, 0}, {0, 0}}}, {{0, 2, 1}});                     // clockwise
  only_answer<Row>({{{0, 0}, {2, 1}, {4, 0}, {2, 4}}}, {{0, 1, 3}, {1, 2, 3}});  // a dart: from its reflex vertex
  only_answer<Row>({{{2, 4}, {4, 0}, {2, 1}, {0, 0}}}, {{0, 2, 1}, {0, 3, 2}});  // clockwise
  only_answer<Row>({{{0, 0}, {1, 0}, {2, 0}, {0, 2}}}, {{0, 1, 3}, {1, 2, 3}});  // a flat vertex
  only_answer<Row>({{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 3}}}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}});
}

TEST_CASE("triangulate_polygon: a last position that repeats the first is no vertex") {
  only_answer<Row>({{{0, 0}, {1, 0}, {0, 1}, {0, 0}}}, {{0, 1, 2}});
  only_answer<Row>({{{0, 0}, {2, 1}, {4, 0}, {2, 4}, {-0.0, 0}}}, {{0, 1, 3}, {1, 2, 3}});
  CHECK(robust::triangulate_polygon({{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}}).size() == 2);
}

TEST_CASE("triangulate_polygon: huge, subnormal, and where the formula's products leave the range") {
  const Polygon2d dart{{{0, 0}, {2, 1}, {4, 0}, {2, 4}}};
  const IndexLists expected{{0, 1, 3}, {1, 2, 3}};
  only_answer<Row>(times(0x1p1021, dart), expected);     // the area is NaN and not below 0
  only_answer<Row>(times(tiny, dart), expected, false);  // all products are 0
  only_answer<Row>({{{0, 0}, {huge, tiny}, {huge, huge}, {tiny, tiny}}}, {{0, 1, 3}, {1, 2, 3}});
  // One ulp beside flat, far from the origin.
  only_answer<Row>({{{1e6 + 0.1, 0}, {1e6 + 0.2, 0x1p-52}, {1e6 + 0.3, 0}, {1e6 + 0.2, 1}}}, expected);
}

TEST_CASE("triangulate_polygon: a comb of 20,000 vertices, upright and lying") {
  Polygon2d comb;
  for (int i = 0; i < 10000; ++i)
    comb.vertices.insert(comb.vertices.end(),
                         {{2.0 * i, 0}, {2.0 * i + 1, 1 + i * 7919.0 - 1000 * std::floor(i * 7.919)}});
  comb.vertices.insert(comb.vertices.end(), {{20000, 0}, {0, -1}});
  for (int lying = 0; lying < 2; ++lying) {
    const IndexLists triangles = robust::triangulate_polygon(comb);
    CHECK(triangles.size() == comb.size() - 2);
    CHECK(fits(comb, triangles));
    for (Point2d& p : comb.vertices) p = {-p.y, p.x};
  }
}

}  // namespace touchstone::proptests::triangulate_polygon_tests
