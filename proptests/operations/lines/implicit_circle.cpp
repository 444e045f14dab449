// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/lines/implicit_circle.h"

#include "proptests/laws.h"

namespace touchstone::proptests::implicit_circle_tests {

using Row = rows::implicit_circle;

LAW("implicit_circle: centre and point may be swapped", circle, p) {
  return ask(asked) == ask(Row::Question{{p, circle.radius}, circle.center});
}

LAW("implicit_circle: in the next larger circle nothing is further out", circle, p) {
  const double larger = catalogue::moved_by_ulps(circle.radius, 1);
  const Location then = ask(Row::Question{{circle.center, larger}, p});
  return ask(asked) == Location::outside || larger == circle.radius || then == Location::inside;
}

LAW("implicit_circle: the centre is inside, and on the boundary of a circle of radius 0", circle, p) {
  return ask(Row::Question{circle, circle.center}) == (circle.radius == 0 ? Location::boundary : Location::inside) &&
         ask(Row::Question{{p, 0}, circle.center}) == (p == circle.center ? Location::boundary : Location::outside);
}

TEST_CASE("implicit_circle: p. 8's x^2 + y^2 - r^2 worked by hand") {
  example<Row>({{{0, 0}, 5}, {3, 4}}, Location::boundary);    // 9 + 16 - 25
  example<Row>({{{0, 0}, 5}, {3, 3}}, Location::inside);      // 9 + 9 - 25
  example<Row>({{{0, 0}, 5}, {4, 4}}, Location::outside);     // 16 + 16 - 25
  example<Row>({{{1, 2}, 13}, {6, 14}}, Location::boundary);  // 25 + 144 - 169
  example<Row>({{{1, 2}, 13}, {-4, -10}}, Location::boundary);
  example<Row>({{{1, 2}, 13}, {6, 14.5}}, Location::outside);  // 25 + 156.25 - 169
}

TEST_CASE("implicit_circle: rounding puts points outside on the boundary") {
  // The doubles are (3 - 2^-53) / 5 and (4 + 2^-52) / 5: 25 times the squares' sum is 25 + 10 * 2^-53 + 5 * 2^-106.
  example<Row>({{{0, 0}, 1}, {0.6, 0.8}}, Location::outside, "rounding");
  example<Row>({{{0, 0}, 0x1p27}, {0x1p27, 1}}, Location::outside, "rounding");  // 2^54 + 1 rounds to 2^54
}

TEST_CASE("implicit_circle: radius zero, huge, subnormal and negative zero") {
  example<Row>({{{2, 3}, 0}, {2, 3}}, Location::boundary);
  example<Row>({{{2, 3}, -0.0}, {2, 3}}, Location::boundary);
  example<Row>({{{2, 3}, 0}, {2, 4}}, Location::outside);
  example<Row>({{{-0.0, 0.0}, 1}, {0.0, -0.0}}, Location::inside);
  example<Row>({{{0, 0}, huge}, {huge, 0}}, Location::boundary);
  example<Row>({{{0, 0}, huge}, {huge, tiny}}, Location::outside, "rounding");  // infinity - infinity
  example<Row>({{{0, 0}, huge}, {huge / 2, huge / 2}}, Location::inside, "rounding");
  example<Row>({{{0, 0}, tiny}, {tiny, 0}}, Location::boundary);
  example<Row>({{{0, 0}, tiny}, {tiny, tiny}}, Location::outside, "rounding");  // every square rounds to 0
}

}  // namespace touchstone::proptests::implicit_circle_tests
