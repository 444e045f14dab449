// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/segment_obb.h"

#include "proptests/obb_passage_laws.h"
#include "robust/mixed/capsule_obb.h"

namespace touchstone::proptests::segment_obb_tests {

using Row = rows::segment_obb;
using namespace worked_boxes;
using namespace obb_passages;

constexpr Worked<Row> worked;

OBB_PASSAGE_LAWS("segment_obb")
REVERSED_PASSAGE_LAW("segment_obb")

ROBUST_LAW("segment_obb: first is 0 and last is 1 where point_in_obb sees the ends in the box", segment, box) {
  const auto answer = ask(asked);
  const bool a = holds_point(box, segment.a), b = holds_point(box, segment.b);
  if (segment.a == segment.b) return a ? answer.last == 0.0 : answer.relation == Relation::none;
  return (!a || answer.first == 0.0) && (!b || answer.last == 1.0);
}

ROBUST_LAW("segment_obb: it meets what the capsule of radius 0 around it touches", segment, box) {
  const Contact contact = robust::capsule_obb({segment, 0}, box);
  return (ask(asked).relation == Relation::hit) == (contact != Contact::disjoint);
}

TEST_CASE("segment_obb: entries and exits worked by hand, and how far it has to be moved to miss or to meet") {
  // x: from 1 / 4 to 3 / 4; y: until 1 / 2. Moved by 2 / 3 on both axes, x from and y until 1 / 3.
  worked({{{-4, 0, 0}, {4, 4, 0}}, cube}, from_to(Rational(1, 4), Rational(1, 2)), Rational(2, 3));
  worked({{{-6, 1, 0}, {0, 1, 0}}, cube}, from_to(Rational(2, 3), 1), 1);
  worked({{{-1, 0, 0}, {1, 0, 0}}, cube}, from_to(0, 1), 2);      // within
  worked({{{-6, 1, 0}, {-3, 1, 0}}, cube}, none, 1);              // ends before it
  worked({{{-6, 5, 0}, {9, 5, 0}}, cube}, none, 3);               // beside it
  worked({{{-4, 1, 0}, {0, 5, 0}}, cube}, none, Rational(1, 2));  // by the edge (-2, 2), 1 / 2 and 1 / 2
  worked({{{-9, 0, 0}, {11, 0, 0}}, turned}, from_to(Rational(11, 80), Rational(61, 80)), 1);
}

TEST_CASE("segment_obb: touching is a hit: by a corner, along a face or an edge, at an end") {
  worked({{{-4, 0, 0}, {0, 4, 4}}, cube}, from_to(Rational(1, 2), Rational(1, 2)), 0);
  worked({{{-6, 2, 0}, {10, 2, 0}}, cube}, from_to(Rational(1, 4), Rational(1, 2)), 0);
  worked({{{-6, 2, 2}, {10, 2, 2}}, cube}, from_to(Rational(1, 4), Rational(1, 2)), 0);
  worked({{{-6, 1, 0}, {-2, 0, 0}}, cube}, from_to(1, 1), 0);
  worked({{{2, 1, 0}, {5, 2, 0}}, cube}, from_to(0, 0), 0);
  worked({{{-9, 7, 0}, {7, 7, 0}}, turned}, from_to(Rational(1, 2), Rational(1, 2)), 0);  // by the edge (-1, 7)
}

TEST_CASE("segment_obb: a segment of length zero is a point") {
  worked({{{1, 1, 1}, {1, 1, 1}}, cube}, from_to(0, 0), 1, "algorithm");
  worked({{{2, 1, 0}, {2, 1, -0.0}}, cube}, from_to(0, 0), 0, "algorithm");
  worked({{{3, 1, 0}, {3, 1, 0}}, cube}, none, 1);
}

TEST_CASE("segment_obb: where half axes are not at right angles the faces are others than the formula takes") {
  // |x - 3 y| <= 2: |y| <= 2 / 3 above x = 0. z: 1. It takes -40 <= 6 x + 2 y <= 40.
  worked({{{0, 3, 0}, {0, -1, 0}}, sheared}, from_to(Rational(7, 12), Rational(11, 12)), 1, "algorithm");
}

TEST_CASE("segment_obb: huge, subnormal and rounding") {
  const Rational far = exact(huge), hair = power_of_two(-60);
  worked({{{-huge, 0, 0}, {0, 0, 0}}, unit_cube}, from_to((far - 1) / far, 1), 1);
  worked({{{-4 * tiny, 0, 0}, {4 * tiny, 0, 0}}, least}, from_to(Rational(3, 8), Rational(5, 8)), exact(tiny),
         "rounding");  // tiny^2 is 0
  // x: from (1 + 2^-60) / (4 + 2^-60), y: until 1 / 4; both are 1 / 4 in double.
  worked({{{-0x1p-60, 0, 0}, {4, 4, 0}}, {{2, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}, none,
         Rational(3 * hair / (8 + hair)), "rounding");
}

TEST_CASE("segment_obb: numbers are refused first, then the half axes") {
  refused<Row>({{{0, 0, 0}, {1, 0, 0}}, dependent}, "obb.half_axes", "linearly independent");
  refused<Row>({{{0, 0, 0}, {not_a_number, 0, 0}}, dependent}, "segment[1][0]", "finite number");
}

}  // namespace touchstone::proptests::segment_obb_tests
