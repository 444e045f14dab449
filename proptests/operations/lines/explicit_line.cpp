// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/lines/explicit_line.h"

#include <cmath>

#include "proptests/laws.h"
#include "robust/lines/explicit_line.h"
#include "robust/lines/orientation.h"

namespace touchstone::proptests::explicit_line_tests {
namespace {

using Row = rows::explicit_line;

Height other(Height h) { return h == Height::above ? Height::below : h == Height::below ? Height::above : Height::on; }

}  // namespace

LAW("explicit_line: reflected in the x axis above becomes below, in the y axis it stays", m, b, p) {
  return ask(Row::Question{-m, -b, {p.x, -p.y}}) == other(ask(asked)) &&
         ask(Row::Question{-m, b, {-p.x, p.y}}) == ask(asked);
}

LAW("explicit_line: powers of two keep the answer", m, b, p) {
  for (const int k : {1, 10, 300}) {
    const double steeper = std::ldexp(m, k), nearer = std::ldexp(p.x, -k);
    if (std::isfinite(steeper) && std::ldexp(nearer, k) == p.x &&
        ask(Row::Question{steeper, b, {nearer, p.y}}) != ask(asked))
      return false;
  }
  return true;
}

LAW("explicit_line: shears and shifts of the lattice keep the answer", m, b, p) {
  if (!on_lattice(asked)) return true;
  const Height height = ask(asked);
  return ask(Row::Question{m + 3, b, {p.x, p.y + 3 * p.x}}) == height &&
         ask(Row::Question{m, b + 12345, {p.x, p.y + 12345}}) == height;
}

ROBUST_LAW("explicit_line: above the line is left of two of its points, from left to right", m, b, p) {
  if (!on_lattice(asked)) return true;
  const Side side = robust::orientation({0, b}, {1, m + b}, p);
  const Height height = ask(asked);
  return side == (height == Height::above ? Side::left : height == Height::below ? Side::right : Side::on);
}

LAW("explicit_line: the next double above is never lower", m, b, p) {
  const double higher = catalogue::moved_by_ulps(p.y, 1);
  const Height height = ask(asked), then = ask(Row::Question{m, b, {p.x, higher}});
  return height == Height::below || higher == p.y || then == Height::above;
}

TEST_CASE("explicit_line: p. 8's y - (m x + b) worked by hand") {
  example<Row>({2, 1, {3, 8}}, Height::above);        // 8 - 7
  example<Row>({2, 1, {3, 7}}, Height::on);           // 7 - 7
  example<Row>({2, 1, {3, 6}}, Height::below);        // 6 - 7
  example<Row>({-0.5, 3, {4, 1}}, Height::on);        // 1 - (-2 + 3)
  example<Row>({-0.5, 3, {-4, 4.5}}, Height::below);  // 4.5 - (2 + 3)
}

TEST_CASE("explicit_line: rounding hides a point below the line") {
  example<Row>({10, 0, {0.1, 1}}, Height::below,
               "rounding");  // ten times the double 0.1 is 1 + 2^-54, which rounds to 1
  example<Row>({1, 0x1p53, {1, 0x1p53}}, Height::below, "rounding");  // 2^53 + 1 rounds to 2^53
}

TEST_CASE("explicit_line: horizontal, huge, subnormal and negative zero") {
  example<Row>({0, 5, {1e9, 5}}, Height::on);
  example<Row>({-0.0, 5, {-1e9, 6}}, Height::above);
  example<Row>({-0.0, -0.0, {huge, 0.0}}, Height::on);
  example<Row>({huge, 0, {huge, huge}}, Height::below);
  example<Row>({huge, -huge, {2, huge}}, Height::on,
               "rounding");  // 2 huge is beyond the range, though 2 huge - huge is not
  example<Row>({tiny, 0, {0.25, 0}}, Height::below, "rounding");  // tiny / 4 rounds to 0
  example<Row>({tiny, tiny, {1, 2 * tiny}}, Height::on);
}

TEST_CASE("explicit_line: three terms that add up to the most that 128 bits may have to hold") {
  // y = -intercept = (2^53 - 1) 2^447, and -m x, positive and odd, ends so many digits below 2^500. The sum is almost
  // 2^501.
  const double most = 0x1p53 - 1;
  for (int span = 107; span <= 140; ++span) {
    const double y = std::ldexp(most, 447), x = std::ldexp(most, 500 - span);
    INFO(span);
    for (const double sign : {1.0, -1.0}) {
      const Height expected = sign > 0 ? Height::above : Height::below;
      CHECK(robust::explicit_line(-sign * most, -sign * y, {x, sign * y}) == expected);
    }
  }
}

}  // namespace touchstone::proptests::explicit_line_tests
