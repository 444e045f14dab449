// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/polygons/point_in_region.h"

#include "proptests/forward_error.h"
#include "proptests/region_laws.h"
#include "robust/polygons/point_in_polygon.h"

namespace touchstone::proptests::point_in_region_tests {
namespace {

using Row = rows::point_in_region;

constexpr Location inside = Location::inside, boundary = Location::boundary, outside = Location::outside;

}  // namespace

LAW("point_in_region: neither directions nor first vertices nor the order of holes matter", region, p) {
  return ask(Row::Question{rewritten(region), p}) == ask(asked);
}

LAW("point_in_region: the vertices of every ring are on the boundary", region) {
  const auto on = [&](const Polygon2d& ring) {
    return ask(Row::Question{region, ring[ring.size() / 2]}) == boundary;
  };
  return on(region.outer) && std::all_of(region.holes.begin(), region.holes.end(), on);
}

ROBUST_LAW("point_in_region: with one hole fewer, only what is in that hole moves", region, p) {
  if (region.holes.empty()) return true;
  Region2d fewer = region;
  fewer.holes.pop_back();
  const Location in_hole = robust::point_in_polygon(region.holes.back(), p),
                 before = ask(Row::Question{fewer, p}), now = ask(asked);
  if (in_hole == boundary) return now == boundary && before != outside;
  return in_hole == inside ? now == outside && before == inside : now == before;
}

TEST_CASE("point_in_region: a square frame worked by hand") {
  for (const Region2d& region : {frame, rewritten(frame)}) {
    example<Row>({region, {1, 1}}, inside);
    example<Row>({region, {7, 4}}, inside);   // level with the hole, to its right
    example<Row>({region, {1, 4}}, inside);   // and to its left
    example<Row>({region, {1, 2}}, inside);   // level with an edge of the hole
    example<Row>({region, {4, 4}}, outside);  // in the hole
    example<Row>({region, {9, 4}}, outside);
    example<Row>({region, {2, 4}}, boundary);
    example<Row>({region, {6, 6}}, boundary);
    example<Row>({region, {0, 3}}, boundary);
  }
  example<Row>({{frame.outer, {}}, {4, 4}}, inside);
}

TEST_CASE("point_in_region: holes that touch the outer ring and each other in points") {
  // From the corner to the middle, and on to an edge.
  const Region2d region{frame.outer, {{{{0, 0}, {4, 4}, {2, 3}}}, {{{4, 4}, {8, 5}, {6, 6}}}}};
  example<Row>({region, {0, 0}}, boundary);
  example<Row>({region, {4, 4}}, boundary);
  example<Row>({region, {8, 5}}, boundary);
  example<Row>({region, {2, 2.5}}, outside);
  example<Row>({region, {6, 5}}, outside);
  example<Row>({region, {4, 5}}, inside);
  example<Row>({region, {5, 4}}, inside);
}

TEST_CASE("point_in_region: a last position that repeats the first is dropped, once") {
  Region2d closed = frame;
  closed.outer.vertices.push_back({0, -0.0}), closed.holes[0].vertices.push_back({2, 2});
  example<Row>({closed, {4, 4}}, outside);
  example<Row>({closed, {1, 4}}, inside);
  closed.holes[0].vertices.push_back({2, 2});
  refused<Row>({closed, {1, 4}}, "region.holes[0][4]", "different from vertex 0: drop one of the two");
}

TEST_CASE("point_in_region: rings that make no region are refused, numbers of all fields first") {
  refused_regions("region", [](const Region2d& region, const std::string& field, const std::string& rule) {
    refused<Row>({region, {1, 1}}, field.c_str(), rule.c_str());
    refused<Row>({region, {1, NAN}}, "point[1]", "finite number");
  });
}

TEST_CASE("point_in_region: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::point_in_region_tests
