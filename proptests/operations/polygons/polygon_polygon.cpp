// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/polygons/polygon_polygon.h"

#include <algorithm>

#include "proptests/closed_rings.h"
#include "proptests/laws.h"

namespace touchstone::proptests::polygon_polygon_tests {
namespace {

using Row = rows::polygon_polygon;

const Polygon2d square{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};

Polygon2d reversed(Polygon2d ring) {
  std::reverse(ring.vertices.begin(), ring.vertices.end());
  return ring;
}
Polygon2d rotated(const Polygon2d& given) {
  Polygon2d ring = opened(given);
  std::rotate(ring.vertices.begin(), ring.vertices.begin() + 1, ring.vertices.end());
  return ring;
}

}  // namespace

LAW("polygon_polygon: which comes first, where a ring begins and which way it runs do not matter", a, b) {
  const Contact contact = ask(asked);
  return ask(Row::Question{reversed(a), b}) == contact && ask(Row::Question{a, rotated(b)}) == contact;
}

LAW("polygon_polygon: a polygon overlaps itself", a) {
  return ask(Row::Question{a, rotated(reversed(a))}) == Contact::overlapping;
}

LAW("polygon_polygon: a polygon touches its image in the line of an edge of its box") {
  Polygon2d a = std::get<0>(asked), image;
  double right = a[0].x;
  for (const Point2d& p : a.vertices) right = std::max(right, p.x);
  for (const Point2d& p : a.vertices) image.vertices.push_back({2 * right - p.x, p.y});
  for (std::size_t i = 0; i < a.size(); ++i) {  // only where the image is exact
    if (std::fabs(a[i].x) > 0x1p50 || a[i].x != std::trunc(a[i].x)) return true;
  }
  return ask(Row::Question{a, image}) == Contact::touching;
}

TEST_CASE("polygon_polygon: p. 18's tests worked by hand") {
  example<Row>({square, {{{1, 1}, {9, 1}, {9, 9}}}}, Contact::overlapping);            // (1, 1) lies inside
  example<Row>({square, {{{-1, 1}, {5, 1}, {5, 2}, {-1, 2}}}}, Contact::overlapping);  // no vertex inside, edges cross
  example<Row>({square, {{{5, 0}, {9, 0}, {9, 9}}}}, Contact::disjoint);
  example<Row>({square, {{{1, 1}, {2, 1}, {2, 2}}}}, Contact::overlapping);  // nested
  example<Row>({{{{1, 1}, {2, 1}, {2, 2}}}, square}, Contact::overlapping);
}

TEST_CASE("polygon_polygon: common boundary points without a common inside are a touch") {
  example<Row>({square, {{{4, 4}, {6, 5}, {5, 6}}}}, Contact::touching);          // one vertex
  example<Row>({square, {{{4, 2}, {6, 1}, {6, 3}}}}, Contact::touching);          // a vertex on an edge
  example<Row>({square, {{{4, 0}, {8, 0}, {8, 4}, {4, 4}}}}, Contact::touching);  // a whole edge
  example<Row>({square, {{{4, 3}, {8, 3}, {8, 9}, {4, 9}}}}, Contact::touching);  // part of an edge
  // A square in the bay of a U, against three of its walls.
  const Polygon2d bay{{{-1, -1}, {3, -1}, {3, 4}, {2, 4}, {2, 0}, {0, 0}, {0, 4}, {-1, 4}}};
  example<Row>({bay, {{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}}, Contact::touching);
  example<Row>({bay, {{{0.5, 0.5}, {1.5, 0.5}, {1.5, 2}, {0.5, 2}}}}, Contact::disjoint);
}

TEST_CASE("polygon_polygon: an overlap that no vertex and no crossing shows") {
  example<Row>({square, square}, Contact::overlapping, "algorithm");
  example<Row>({square, {{{2, 0}, {4, 2}, {2, 4}, {0, 2}}}}, Contact::overlapping, "algorithm");  // inscribed
  example<Row>({square, {{{0, 0}, {4, 0}, {4, 2}, {0, 2}}}}, Contact::overlapping, "algorithm");  // shares three edges
  example<Row>({square, {{{0, 0}, {4, 0}, {4, 4}}}}, Contact::overlapping, "algorithm");          // half of it
  example<Row>({square, {{{0, 0}, {2, 1}, {1, 2}}}}, Contact::overlapping);  // nested, sharing a vertex
  // A band through two opposite vertices.
  example<Row>({square, {{{-1, -1}, {5, 5}, {6, 5}, {0, -1}}}}, Contact::overlapping);
}

TEST_CASE("polygon_polygon: a last position that repeats the first is dropped, once") {
  const Polygon2d triangle{{{1, 1}, {9, 1}, {9, 9}}}, beside{{{4, 2}, {6, 1}, {6, 3}}}, apart{{{5, 0}, {9, 0}, {9, 9}}};
  for (const Polygon2d& a : {square, closed(square)}) {
    example<Row>({a, closed(triangle)}, Contact::overlapping);
    example<Row>({closed(triangle), a}, Contact::overlapping);
    example<Row>({a, closed(beside)}, Contact::touching);
    example<Row>({a, closed(apart)}, Contact::disjoint);
  }
  example<Row>({{{{0, -0.0}, {4, 0}, {4, 4}, {0, 4}, {-0.0, 0}}}, beside}, Contact::touching);
  refused<Row>({closed(closed(square)), {{{0, 0}, {1, 1}, {0, 0}}}}, "a[4]",
               "different from vertex 0: drop one of the two");
}

TEST_CASE("polygon_polygon: huge, subnormal and in the last place") {
  example<Row>({{{{-huge, -huge}, {huge, -huge}, {huge, huge}}}, {{{-huge, -huge}, {huge, huge}, {-huge, huge}}}},
               Contact::touching);
  example<Row>({{{{0, 0}, {tiny, 0}, {tiny, tiny}}}, {{{0, 0}, {tiny, tiny}, {0, tiny}}}}, Contact::touching);
  const double above = std::nextafter(4.0, 5.0), below = std::nextafter(4.0, 3.0);
  example<Row>({square, {{{above, 2}, {6, 1}, {6, 3}}}}, Contact::disjoint);
  example<Row>({square, {{{below, 2}, {6, 1}, {6, 3}}}}, Contact::overlapping);
}

}  // namespace touchstone::proptests::polygon_polygon_tests
