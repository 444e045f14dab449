// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/ray_obb.h"

#include "proptests/obb_passage_laws.h"
#include "robust/mixed/segment_obb.h"

namespace touchstone::proptests::ray_obb_tests {

using Row = rows::ray_obb;
using namespace worked_boxes;
using namespace obb_passages;

constexpr Worked<Row> worked;

OBB_PASSAGE_LAWS("ray_obb")
DIRECTION_PASSAGE_LAW("ray_obb")

ROBUST_LAW("ray_obb: first is 0 where point_in_obb sees the origin in the box, and only where t underflows else", ray,
           box) {
  const auto answer = ask(asked);
  if (holds_point(box, ray.origin)) return answer.relation == Relation::hit && *answer.first == 0;
  return answer.relation == Relation::none || *answer.first > 0 || !on_lattice(asked);
}

ROBUST_LAW("ray_obb: on the lattice a ray meets what the segment of its direction meets", ray, box) {
  if (!on_lattice(asked)) return true;
  const auto answer = ask(asked), part = robust::segment_obb({ray.origin, ray.origin + ray.direction}, box);
  if (part.relation == Relation::none) return answer.relation == Relation::none || *answer.first >= 1;
  return answer.first == part.first && std::min(*answer.last, 1.0) == *part.last;
}

TEST_CASE("ray_obb: entries and exits worked by hand, and how far the ray has to be moved to miss or to meet") {
  // x: from 1 to 3; y: until 2. Moved by 2 / 3 on both axes, x from and y until 4 / 3.
  worked({{{-4, 0, 0}, {2, 1, 0}}, cube}, from_to(1, 2), Rational(2, 3));
  worked({{{-6, 1, 0}, {-1, 0, 0}}, cube}, none, 4);  // away
  worked({{{-6, 5, 0}, {1, 0, 0}}, cube}, none, 3);   // beside it
  // x: from 2; y: until 1. Moved by 1 / 2 on both axes, both 3 / 2.
  worked({{{-4, 1, 0}, {1, 1, 0}}, cube}, none, Rational(1, 2));
  // Along (3, 4): from (27 - 25) / 3; along (-4, 3): from 11 / 4 to 61 / 4. 1 above and below it the box ends.
  worked({{{-9, 0, 0}, {1, 0, 0}}, turned}, from_to(Rational(11, 4), Rational(61, 4)), 1);
  worked({{{-9, 8, 0}, {1, 0, 0}}, turned}, none, 1);  // its corner (-1, 7) is 1 lower
}

TEST_CASE("ray_obb: touching is a hit: by a corner, along a face or an edge, from the boundary") {
  worked({{{-4, 0, 0}, {1, 1, 1}}, cube}, from_to(2, 2), 0);                   // by the corner (-2, 2, 2)
  worked({{{-6, 1, 0}, {4, 1, 0}}, cube}, from_to(1, 1), 0);                   // by an edge
  worked({{{-6, 2, 0}, {1, 0, 0}}, cube}, from_to(4, 8), 0);                   // along a face
  worked({{{-6, 2, 2}, {1, -0.0, 0}}, cube}, from_to(4, 8), 0);                // along an edge
  worked({{{-2, 1, 0}, {-1, 0, 0}}, cube}, from_to(0, 0), 0);                  // away from a face
  worked({{{2, 1, 0}, {-1, 0, 0}}, cube}, from_to(0, 4), 1);                   // into it, 1 below y = 2
  worked({{{-9, 7, 0}, {1, 0, 0}}, turned}, from_to(8, 8), 0);                 // by the edge through (-1, 7)
  worked({{{0, -1, 1}, {3, 4, 0}}, turned}, from_to(0, Rational(29, 25)), 0);  // along (3, 4), on top
}

TEST_CASE("ray_obb: where half axes are not at right angles the faces are others than the formula takes") {
  // |x - 3 y| <= 2: |y| <= 2 / 3 above x = 0. z: 1. It takes -40 <= 6 x + 2 y <= 40.
  worked({{{0, 9, 0}, {0, -1, 0}}, sheared}, from_to(Rational(25, 3), Rational(29, 3)), 1, "algorithm");
  // y = 1: x from 1 to 5. It takes |x| <= 2 and -40 <= 6 x + 2 <= 40.
  worked({{{-9, 1, 0}, {1, 0, 0}}, sheared}, from_to(10, 14), 1, "algorithm");
}

TEST_CASE("ray_obb: huge, subnormal and rounding") {
  const Rational far = exact(huge), hair = power_of_two(-60);
  worked({{{-huge, 0, 0}, {huge, 0, 0}}, unit_cube}, from_to((far - 1) / far, (far + 1) / far), 1);
  worked({{{-4 * tiny, 0, 0}, {tiny, 0, 0}}, least}, from_to(3, 5), exact(tiny), "rounding");  // tiny^2 is 0
  // x: from (1 + 2^-60) / 4, which is 1 / 4 in double; y: until 1 / 4. Moved by half of the difference times 4.
  worked({{{-0x1p-60, 0, 0}, {4, 4, 0}}, {{2, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}, none, Rational(hair / 2),
         "rounding");
}

TEST_CASE("ray_obb: numbers are refused first, then the direction, then the half axes") {
  refused<Row>({{{0, 0, 0}, {0, -0.0, 0}}, dependent}, "ray.direction", "nonzero direction");
  refused<Row>({{{0, 0, 0}, {1, 0, 0}}, dependent}, "obb.half_axes", "linearly independent");
  refused<Row>({{{0, 0, 0}, {0, 0, 0}}, {{infinity, 0, 0}, dependent.half_axes}}, "obb.center[0]", "finite number");
}

}  // namespace touchstone::proptests::ray_obb_tests
