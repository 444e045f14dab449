// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/polygons/region_region.h"

#include "proptests/region_laws.h"
#include "robust/polygons/polygon_polygon.h"

namespace touchstone::proptests::region_region_tests {
namespace {

using Row = rows::region_region;

constexpr Contact overlapping = Contact::overlapping, touching = Contact::touching, disjoint = Contact::disjoint;

Region2d box(double x, double y, double width, double height) {
  return {{{{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}}, {}};
}

}  // namespace

LAW("region_region: neither directions nor first vertices nor the order of holes matter", a, b) {
  return ask(Row::Question{rewritten(a), b}) == ask(asked) && ask(Row::Question{a, rewritten(b)}) == ask(asked);
}

LAW("region_region: a region overlaps itself and touches what fills a hole", a) {
  if (ask(Row::Question{a, rewritten(a)}) != overlapping) return false;
  return std::all_of(a.holes.begin(), a.holes.end(), [&](const Polygon2d& hole) {
    return ask(Row::Question{a, {hole, {}}}) == touching && ask(Row::Question{{hole, {}}, a}) == touching;
  });
}

ROBUST_LAW("region_region: without holes it is polygon_polygon; with them there is not more in common", a, b) {
  const Contact outer = robust::polygon_polygon(a.outer, b.outer);
  if (ask(Row::Question{{a.outer, {}}, {b.outer, {}}}) != outer) return false;
  return outer == overlapping || ask(asked) == outer;
}

TEST_CASE("region_region: what lies in a hole, touches its edges or leaves it") {
  for (const Region2d& region : {frame, rewritten(frame)}) {
    example<Row>({region, box(3, 3, 2, 2)}, disjoint);
    example<Row>({region, box(3, 3, 3, 2)}, touching);                       // along an edge
    example<Row>({region, {{{{3, 3}, {6, 4}, {3, 5}}}, {}}}, touching);      // a vertex on an edge
    example<Row>({region, box(2, 2, 4, 4)}, touching);                       // fills it
    example<Row>({region, box(3, 3, 3.5, 2)}, overlapping);
    example<Row>({region, box(2, 2, 4, 6)}, overlapping, "algorithm");  // fills it and more: no vertex within
    example<Row>({region, box(9, 0, 2, 2)}, disjoint);
    example<Row>({region, box(8, 0, 2, 2)}, touching);
    example<Row>({region, box(0.5, 0.5, 1, 1)}, overlapping);
    example<Row>({region, box(-1, -1, 10, 10)}, overlapping);
  }
}

TEST_CASE("region_region: frames within frames") {
  Region2d small = frame;
  for (Polygon2d* ring : {&small.outer, &small.holes[0]})
    for (Point2d& p : ring->vertices) p = {2.5 + p.x / 4, 2.5 + p.y / 4};
  example<Row>({frame, small}, disjoint);
  for (Polygon2d* ring : {&small.outer, &small.holes[0]})
    for (Point2d& p : ring->vertices) p = {2 * p.x - 5, 2 * p.y - 5};
  example<Row>({frame, small}, overlapping);
  example<Row>({small, frame}, overlapping);
}

TEST_CASE("region_region: in a corner, what one hole leaves the other's hole may take") {
  // The outer corner of a square is cut by a hole from (0, 0) towards (6, 2) and (2, 6).
  const Region2d cut{frame.outer, {{{{0, 0}, {6, 2}, {2, 6}}}}};
  example<Row>({cut, {{{{0, 0}, {3, 2}, {2, 3}}}, {}}}, touching);     // within the hole
  example<Row>({cut, {{{{0, 0}, {5, 1}, {4, 3}}}, {}}}, overlapping);  // begins before it
  // Where outer rings cross, holes of both leave nothing; then the second leaves more than the first takes.
  const auto crossing = [](double kept) {
    return Row::Question{{{{{-8, 0}, {8, 0}, {8, 8}, {-8, 8}}}, {{{{0, 0}, {6, 4}, {0, 8}, {-6, 4}}}}},
                         {{{{0, -8}, {16, -8}, {16, 16}, {0, 16}}},
                          {{{{0, 0}, {10, -4}, {10, 12}, {0, 8}, {kept, 4}}}}}};
  };
  example<Row>(crossing(5), touching, "algorithm");
  example<Row>(crossing(6), touching, "algorithm");
  example<Row>(crossing(7), overlapping);
}

TEST_CASE("region_region: regions that are none are refused, a before b, numbers first") {
  refused_regions("a", [](const Region2d& a, const std::string& field, const std::string& rule) {
    refused<Row>({a, {{{{0, 0}, {1, 1}}}, {}}}, field.c_str(), rule.c_str());
    refused<Row>({a, {{{{0, 0}, {1, 1}, {NAN, 0}}}, {}}}, "b.outer[2][0]", "finite number");
  });
  refused_regions("b", [](const Region2d& b, const std::string& field, const std::string& rule) {
    refused<Row>({frame, b}, field.c_str(), rule.c_str());
  });
}

}  // namespace touchstone::proptests::region_region_tests
