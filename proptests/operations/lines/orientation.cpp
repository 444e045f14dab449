// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/lines/orientation.h"

#include "proptests/forward_error.h"

namespace touchstone::proptests::orientation_tests {
namespace {

using Row = rows::orientation;

Side other(Side side) { return side == Side::left ? Side::right : side == Side::right ? Side::left : Side::on; }

}  // namespace

LAW("orientation: two points swapped turn the side over, a cyclic shift keeps it", p0, p1, p) {
  const Side side = ask(asked);
  const auto of = [&](const Point2d& a, const Point2d& b, const Point2d& c) { return ask(Row::Question{a, b, c}); };
  return of(p1, p, p0) == side && of(p, p0, p1) == side && of(p1, p0, p) == other(side) &&
         of(p0, p, p1) == other(side) && of(p, p1, p0) == other(side);
}

LAW("orientation: both points of the line are on it, and every point on a line of one point", p0, p1, p) {
  return ask(Row::Question{p0, p1, p0}) == Side::on && ask(Row::Question{p0, p1, p1}) == Side::on &&
         ask(Row::Question{p, p, p1}) == Side::on;
}

TEST_CASE("orientation: p. 16's formula worked by hand") {
  // (y - y0)(x1 - x0) - (x - x0)(y1 - y0)
  example<Row>({{0, 0}, {4, 0}, {1, 2}}, Side::left);      // 2 * 4 - 1 * 0 = 8
  example<Row>({{0, 0}, {4, 0}, {1, -2}}, Side::right);    // -2 * 4 - 1 * 0 = -8
  example<Row>({{1, 1}, {3, 2}, {7, 4}}, Side::on);        // 3 * 2 - 6 * 1 = 0
  example<Row>({{1, 1}, {3, 2}, {7, 4.5}}, Side::left);    // 3.5 * 2 - 6 * 1 = 1
  example<Row>({{3, 2}, {1, 1}, {7, 4.5}}, Side::right);   // 2.5 * -2 - 4 * -1 = -1
  example<Row>({{-2, -3}, {-2, 5}, {-3, 0}}, Side::left);  // 3 * 0 - (-1) * 8 = 8
}

TEST_CASE("orientation: rounding hides a point beside the line") {
  // 0.1 as a double is 3602879701896397 / 2^55; ten times that is 1 + 2^-54, which rounds to 1.
  example<Row>({{0, 0}, {1, 10}, {0.1, 1}}, Side::right, "rounding");
  example<Row>({{0, 0}, {0.3, 0.3}, {0.1, 0.1}}, Side::on);
}

TEST_CASE("orientation: coincident points, huge, subnormal and negative zero") {
  example<Row>({{2, 3}, {2, 3}, {7, 8}}, Side::on);
  example<Row>({{2, 3}, {2, 3}, {2, 3}}, Side::on);
  example<Row>({{-0.0, 0.0}, {0.0, -0.0}, {1, 1}}, Side::on);
  example<Row>({{-0.0, -0.0}, {1, -0.0}, {5, 0.0}}, Side::on);
  // huge * huge is beyond the range.
  example<Row>({{0, 0}, {huge, 0}, {0, huge}}, Side::left);
  example<Row>({{0, 0}, {huge, huge}, {huge, 1}}, Side::right);
  example<Row>({{0, 0}, {huge, huge}, {huge, huge / 2}}, Side::right, "rounding");  // infinity - infinity
  // tiny * tiny is below it.
  example<Row>({{0, 0}, {tiny, 0}, {0, tiny}}, Side::left, "rounding");
  example<Row>({{0, 0}, {tiny, tiny}, {tiny, 0}}, Side::right, "rounding");
  example<Row>({{0, 0}, {huge, tiny}, {huge, 2 * tiny}}, Side::left);
}

CONTRACT("orientation: the formula in double is right beyond the margin of its contract", p0, p1, p) {
  const double left = (p.y - p0.y) * (p1.x - p0.x), right = (p.x - p0.x) * (p1.y - p0.y);
  if (!finite(left, right, left - right)) return true;
  const Rational u = unit();
  const Rational bound = (3 + 16 * u) * u * (size(left) + size(right)) + power_of_two(-1073);
  return *truth.margin <= bound || answer == truth.answer;
}

TEST_CASE("orientation: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::orientation_tests
