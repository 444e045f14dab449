// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/planes/point_ground_plane.h"

#include "proptests/forward_error.h"
#include "robust/lines/explicit_line.h"

namespace touchstone::proptests::point_ground_plane_tests {
namespace {

using Row = rows::point_ground_plane;

Height other(Height h) { return h == Height::above ? Height::below : h == Height::below ? Height::above : Height::on; }

}  // namespace

LAW("point_ground_plane: seen in a mirror on the ground, above is below", p) {
  return ask(Row::Question{{p.x, -p.y, p.z}}) == other(ask(asked));
}

LAW("point_ground_plane: x and z play no part, turned, exchanged or replaced", p) {
  const Height height = ask(asked);
  for (const Point3d& moved : {Point3d{p.z, p.y, p.x}, {-p.z, p.y, p.x}, {-p.x, p.y, -p.z}, {0, p.y, huge}}) {
    if (ask(Row::Question{moved}) != height) return false;
  }
  return true;
}

LAW("point_ground_plane: the next double above is never lower, and only one height is on the ground", p) {
  const double higher = catalogue::moved_by_ulps(p.y, 1);
  const Height height = ask(asked), then = ask(Row::Question{{p.x, higher, p.z}});
  return height == Height::below || higher == p.y || then == Height::above;
}

ROBUST_LAW("point_ground_plane: it is explicit_line with slope and intercept 0, seen along z", p) {
  return robust::explicit_line(0, 0, {p.x, p.y}) == ask(asked) &&
         robust::explicit_line(-0.0, 0, {p.z, p.y}) == ask(asked);
}

TEST_CASE("point_ground_plane: p. 20's sign of y worked by hand") {
  example<Row>({{1, 2, 3}}, Height::above);
  example<Row>({{1, 0, 3}}, Height::on);
  example<Row>({{1, -2, 3}}, Height::below);
  example<Row>({{-4, 0.5, -1e300}}, Height::above);
}

CONTRACT("point_ground_plane: the formula in double is right everywhere, as in exact arithmetic") {
  return answer == truth.answer;
}

TEST_CASE("point_ground_plane: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::point_ground_plane_tests
