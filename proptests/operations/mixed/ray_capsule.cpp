// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/ray_capsule.h"

#include "proptests/capsule_passage_laws.h"

namespace touchstone::proptests::ray_capsule_tests {

using Row = rows::ray_capsule;
using namespace capsule_passages;

constexpr Worked<Row> worked;
CAPSULE_PASSAGE_LAWS("ray_capsule")
DIRECTION_PASSAGE_LAW("ray_capsule")

ROBUST_LAW("ray_capsule: first is 0 where the origin is in the capsule, and only where t underflows else", ray,
           capsule) {
  const auto answer = ask(asked);
  if (holds_point(capsule, ray.origin)) return answer.relation == Relation::hit && *answer.first == 0;
  return answer.relation == Relation::none || *answer.first > 0 || !on_lattice(asked);
}

TEST_CASE("ray_capsule: through the cylinder and the balls, worked by hand; margin: |f| where it is least") {
  worked({{{2, -5, 0}, {0, 1, 0}}, bar}, from_to(whole(3), whole(7)), 4);                // across: |t - 5| = 2
  worked({{{2, -5, 1}, {0, 1, 0}}, bar}, from_to(whole(5) - root, whole(5) + root), 3);  // (t - 5)^2 + 1 = 4
  worked({{{-6, 0, 0}, {1, 0, 0}}, bar}, from_to(whole(4), whole(12)), 4);               // along the axis: -2 to 6
  // Beside the axis, by both balls: (t - 3)^2 + 1 = 4 and (t - 7)^2 + 1 = 4.
  worked({{{-3, 1, 0}, {1, 0, 0}}, bar}, from_to(whole(3) - root, whole(7) + root), 3);
  // With s = t - 1: from the first ball, 5 s^2 - 8 s = 0, to the side, s = 2; least at s = 4 / 5.
  worked({{{-4, -1, 0}, {2, 1, 0}}, bar}, from_to(whole(1), whole(3)), Rational(16, 5));
  worked({{{8, 1, 0}, {-2, -1, 0}}, {{{4, 0, 0}, {0, 0, 0}}, 2}}, from_to(whole(1), whole(3)), Rational(16, 5));
  // Where the ball and the cylinder meet, at (0, 2): (t - 1)^2 + (t - 1)^2 = 4 (t - 1); least at (-1, 1).
  worked({{{-3, -1, 0}, {1, 1, 0}}, bar}, from_to(whole(1), whole(3)), 2);
  worked({{{11, -2, 0}, {-4, 3, 0}}, slanted}, from_to(whole(1), whole(3)), 25);  // 10 - 5 t = 5 and -5
}

TEST_CASE("ray_capsule: past it, and away from it") {
  worked({{{2, 5, 0}, {1, 0, 0}}, bar}, none, 21);   // 5^2 - 2^2
  worked({{{-3, -5, 0}, {0, 1, 0}}, bar}, none, 5);  // past an end: 3^2 - 2^2
  worked({{{2, -5, 3}, {0, 1, 0}}, bar}, none, 5);   // across, above it
  worked({{{8, 0, 0}, {1, 0, 0}}, bar}, none, 12);   // away: 4^2 - 2^2
  worked({{{2, 3, 0}, {1, 1, 0}}, bar}, none, 5);
}

TEST_CASE("ray_capsule: touching is a hit: tangent, sliding, from the boundary; inside it is one from the start") {
  worked({{{2, -5, 2}, {0, 1, 0}}, bar}, from_to(whole(5), whole(5)), 0);
  worked({{{-2, -5, 0}, {0, 1, 0}}, bar}, from_to(whole(5), whole(5)), 0);     // an end
  worked({{{-6, 2, 0}, {1, -0.0, 0}}, bar}, from_to(whole(6), whole(10)), 0);  // along the side, from 0 to 4
  worked({{{1, 2, 0}, {-1, 0, 0}}, bar}, from_to(whole(0), whole(1)), 0);      // from there
  worked({{{6, 0, 0}, {1, 0, 0}}, bar}, from_to(whole(0), whole(0)), 0);
  worked({{{1, 2, 0}, {0, -1, 0}}, bar}, from_to(whole(0), whole(4)), 4);
  worked({{{1, 1, 0}, {1, 0, 0}}, bar}, from_to(whole(0), whole(3) + root), 3);
}

TEST_CASE("ray_capsule: a capsule without length is a ball, without radius a segment, and without both a point") {
  worked({{{-3, 1, 0}, {1, 0, 0}}, {point, 2}}, from_to(whole(3) - root, whole(3) + root), 3);
  worked({{{2, -5, 0}, {0, 1, 0}}, {axis, 0}}, from_to(whole(5), whole(5)), 0);
  worked({{{-6, 0, 0}, {2, 0, 0}}, {axis, -0.0}}, from_to(whole(3), whole(5)), 0);  // along it
  worked({{{1, 0, 0}, {1, 0, 0}}, {axis, 0}}, from_to(whole(0), whole(3)), 0);
  worked({{{2, -5, 1}, {0, 1, 0}}, {axis, 0}}, none, 1);
  worked({{{-1, 0, 0}, {1, 0, 0}}, {point, 0}}, from_to(whole(1), whole(1)), 0);
}

TEST_CASE("ray_capsule: huge, subnormal and rounding") {
  const Rational far = exact(huge), square = exact(tiny) * exact(tiny);
  worked({{{-huge, 0, 0}, {huge, 0, 0}}, {{{0, 0, 0}, {1, 0, 0}}, 1}},
         from_to(Surd(Rational((far - 1) / far)), Surd(Rational((far + 2) / far))), 1, "rounding");  // huge^2
  worked({{{2 * tiny, -5 * tiny, 0}, {0, tiny, 0}}, {{{0, 0, 0}, {4 * tiny, 0, 0}}, 2 * tiny}},
         from_to(whole(3), whole(7)), Rational(4 * square), "rounding");
  worked({{{-0x1p30, 2, 1}, {1, 0, 0}}, {{{0, 0, 0}, {0, 0, 4}}, 1}}, none, 3, "rounding");  // 2^60 + 3
}

TEST_CASE("ray_capsule: numbers are refused first, then the direction, then the radius") {
  refused<Row>({{{0, 0, 0}, {0, -0.0, 0}}, {axis, -1}}, "ray.direction", "nonzero direction");
  refused<Row>({{{0, 0, 0}, {1, 0, 0}}, {axis, -1}}, "capsule.radius", "radius >= 0");
  refused<Row>({{{0, 0, 0}, {0, 0, 0}}, {{{0, 0, 0}, {0, 0, infinity}}, -1}}, "capsule.segment[1][2]", "finite number");
}

TEST_CASE("ray_capsule: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::ray_capsule_tests
