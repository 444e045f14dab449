// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/closest_point_on_segment.h"
#include "oracle/mixed/closest_point_on_triangle.h"
#include "oracle/mixed/convex_distance.h"
#include "oracle/mixed/segment_segment_distance.h"
#include "oracle/planes/point_plane.h"
#include "oracle/planes/polygon_normal.h"
#include "proptests/catch.h"

/// A distance that is no fraction is a root, not a fraction near it.
namespace touchstone::proptests::exact_distances_tests {
namespace {

const Segment3d along_x{{0, 0, 0}, {1, 0, 0}};

}  // namespace

TEST_CASE("exact distances: of nearest points") {
  const auto of_point = oracle::closest_point_on_segment(Point3d{0, 1, 1}, along_x);
  CHECK(of_point.answer.distance.text() == "sqrt(2)");
  CHECK(of_point.certificate().kind == "irrational_root");
  const auto in_plane = oracle::closest_point_on_segment(Point2d{4, 6}, Segment2d{{0, 0}, {1, 2}});
  CHECK(in_plane.answer.distance.text() == "5");  // 3, 4, 5
  CHECK(in_plane.certificate().kind == "root");
  const auto of_triangle = oracle::closest_point_on_triangle({3, 3, 1}, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
  CHECK(of_triangle.answer.distance.text() == "3");  // 2, 2, 1
  const auto of_segments = oracle::segment_segment_distance(along_x, Segment3d{{0, 2, 2}, {1, 2, 2}});
  CHECK(of_segments.answer.distance.text() == "2*sqrt(2)");
  CHECK(of_segments.certificate().kind == "irrational_root");
}

TEST_CASE("exact distances: of solids") {
  const std::vector<Face> faces{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const Meshd a{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, faces},
      b{{{0, -3, -4}, {1, -3, -4}, {0, -2, -4}, {0, -3, -3}}, faces};
  // Nearest to the origin is the corner (0, -3, -3): it is the foot on the edge y + z = -6.
  const auto found = oracle::convex_distance(a, b);
  CHECK(found.answer.distance.text() == "3*sqrt(2)");
  CHECK(found.certificate().kind == "irrational_root");
}

TEST_CASE("exact distances: of planes, with a sign, and unit normals") {
  const Plane3d plane{{1, 1, 0}, 0};
  CHECK(oracle::point_plane(plane, {1, 0, 0}).answer.signed_distance.text() == "1/2*sqrt(2)");
  CHECK(oracle::point_plane(plane, {-1, 0, 0}).answer.signed_distance.text() == "-1/2*sqrt(2)");
  CHECK(oracle::point_plane(plane, {1, -1, 0}).certificate().kind == "root");
  // (1, 0, 1) x (0, 1, 2) = (-1, -2, 1), of length sqrt(6).
  const auto normal = oracle::polygon_normal({{{0, 0, 0}, {1, 0, 1}, {0, 1, 2}}});
  REQUIRE(normal.answer.unit);
  CHECK(normal.answer.unit->x.text() == "-1/6*sqrt(6)");
  CHECK(normal.answer.unit->y.text() == "-1/3*sqrt(6)");
  CHECK(normal.answer.unit->z.text() == "1/6*sqrt(6)");
  CHECK(normal.certificate().kind == "irrational_root");
}

}  // namespace touchstone::proptests::exact_distances_tests
