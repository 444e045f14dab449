// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/segment_capsule.h"

#include "proptests/capsule_passage_laws.h"
#include "robust/mixed/capsule_capsule.h"
#include "robust/mixed/ray_capsule.h"

namespace touchstone::proptests::segment_capsule_tests {

using Row = rows::segment_capsule;
using namespace capsule_passages;

constexpr Worked<Row> worked;

CAPSULE_PASSAGE_LAWS("segment_capsule")
REVERSED_PASSAGE_LAW("segment_capsule")

ROBUST_LAW("segment_capsule: first is 0 and last is 1 where the ends are in the capsule", segment, capsule) {
  const auto answer = ask(asked);
  const bool a = holds_point(capsule, segment.a), b = holds_point(capsule, segment.b);
  if (segment.a == segment.b) return a ? answer.last == 0.0 : answer.relation == Relation::none;
  return (!a || answer.first == 0.0) && (!b || answer.last == 1.0);
}

ROBUST_LAW("segment_capsule: it meets what the capsule of radius 0 around it touches", segment, capsule) {
  const Contact contact = robust::capsule_capsule({segment, 0}, capsule);
  return (ask(asked).relation == Relation::hit) == (contact != Contact::disjoint);
}

ROBUST_LAW("segment_capsule: on the lattice the ray through it is at the same places", segment, capsule) {
  if (!on_lattice(asked) || segment.a == segment.b) return true;
  const auto answer = ask(asked), all = robust::ray_capsule({segment.a, segment.b - segment.a}, capsule);
  if (answer.relation == Relation::none) return all.relation == Relation::none || *all.first >= 1;
  return answer.first == all.first && *answer.last == std::min(*all.last, 1.0);
}

TEST_CASE("segment_capsule: through the cylinder and the balls, worked by hand; margin: |f| where it is least") {
  worked({{{2, -5, 0}, {2, 5, 0}}, bar}, from_to(Rational(3, 10), Rational(7, 10)), 4);  // across: |10 t - 5| = 2
  worked({{{-6, 0, 0}, {6, 0, 0}}, bar}, from_to(Rational(1, 3), whole(1)), 4);          // it ends at the other end
  // Beside the axis: (3 t - 3)^2 + 1 = 4; and until it is beyond the other end.
  worked({{{-3, 1, 0}, {0, 1, 0}}, bar}, from_to(whole(1) - root / whole(3), whole(1)), 3);
  worked({{{-3, 1, 0}, {7, 1, 0}}, bar},
         from_to(Rational(3, 10) - root / whole(10), Rational(7, 10) + root / whole(10)), 3);
  // As for ray_capsule, in four times the direction: from a ball to the side.
  worked({{{-4, -1, 0}, {4, 3, 0}}, bar}, from_to(Rational(1, 4), Rational(3, 4)), Rational(16, 5));
  worked({{{1, 1, 0}, {3, -1, 0}}, bar}, from_to(whole(0), whole(1)), 4);        // within
  worked({{{1, 1, 0}, {3, 1, 0}}, bar}, from_to(whole(0), whole(1)), 3);         // along the axis
  worked({{{1, 1, 0}, {1, -5, 0}}, bar}, from_to(whole(0), Rational(1, 2)), 4);  // out of the side
  worked({{{11, -2, 0}, {-5, 10, 0}}, slanted}, from_to(Rational(1, 4), Rational(3, 4)), 25);
}

TEST_CASE("segment_capsule: past it, short of it, and away from it") {
  worked({{{0, 5, 0}, {4, 5, 0}}, bar}, none, 21);    // beside it: 5^2 - 2^2
  worked({{{-3, -5, 0}, {-3, 5, 0}}, bar}, none, 5);  // past an end: 3^2 - 2^2
  worked({{{2, -5, 0}, {2, -3, 0}}, bar}, none, 5);   // short of the side
  worked({{{-9, 0, 0}, {-3, 0, 0}}, bar}, none, 5);   // short of an end
  worked({{{8, 0, 0}, {9, 0, 0}}, bar}, none, 12);    // away
}

TEST_CASE("segment_capsule: touching is a hit: tangent, sliding, at an end") {
  worked({{{2, -5, 2}, {2, 5, 2}}, bar}, from_to(Rational(1, 2), Rational(1, 2)), 0);
  worked({{{-6, 2, 0}, {10, 2, 0}}, bar}, from_to(Rational(3, 8), Rational(5, 8)), 0);  // along the side
  worked({{{1, 2, 0}, {3, 2, 0}}, bar}, from_to(whole(0), whole(1)), 0);
  worked({{{2, -5, 0}, {2, -2, 0}}, bar}, from_to(whole(1), whole(1)), 0);
  worked({{{6, 0, 0}, {7, 0, 0}}, bar}, from_to(whole(0), whole(0)), 0);
}

TEST_CASE("segment_capsule: points, balls and capsules without radius") {
  worked({{{2, 1, 0}, {2, 1, 0}}, bar}, from_to(whole(0), whole(0)), 3, "algorithm");
  worked({{{2, 2, 0}, {2, 2, -0.0}}, bar}, from_to(whole(0), whole(0)), 0, "algorithm");  // on the side
  worked({{{2, 3, 0}, {2, 3, 0}}, bar}, none, 5);
  worked({{{-3, 0, 0}, {3, 0, 0}}, {point, 2}}, from_to(Rational(1, 6), Rational(5, 6)), 4);
  worked({{{2, -5, 0}, {2, 5, 0}}, {axis, -0.0}}, from_to(Rational(1, 2), Rational(1, 2)), 0);
  worked({{{-4, 0, 0}, {2, 0, 0}}, {axis, 0}}, from_to(Rational(2, 3), whole(1)), 0);  // into it, along it
  worked({{{0, 0, 0}, {0, 0, 0}}, {point, 0}}, from_to(whole(0), whole(0)), 0, "algorithm");
}

TEST_CASE("segment_capsule: huge, subnormal and rounding") {
  const Rational far = exact(huge), square = exact(tiny) * exact(tiny);
  worked({{{-huge, 0, 0}, {0, 0, 0}}, {{{0, 0, 0}, {1, 0, 0}}, 1}}, from_to(Rational((far - 1) / far), whole(1)), 1,
         "rounding");  // huge^2
  worked({{{2 * tiny, -5 * tiny, 0}, {2 * tiny, 3 * tiny, 0}}, {{{0, 0, 0}, {4 * tiny, 0, 0}}, 2 * tiny}},
         from_to(Rational(3, 8), Rational(7, 8)), Rational(4 * square), "rounding");
  worked({{{-0x1p30, 2, 1}, {0x1p30, 2, 1}}, {{{0, 0, 0}, {0, 0, 4}}, 1}}, none, 3, "rounding");  // 2^60 + 3
}

TEST_CASE("segment_capsule: numbers are refused first, then the radius") {
  refused<Row>({{{0, 0, 0}, {0, 0, 0}}, {axis, -1}}, "capsule.radius", "radius >= 0");
  refused<Row>({{{0, 0, 0}, {0, not_a_number, 0}}, {axis, -1}}, "segment[1][1]", "finite number");
}

}  // namespace touchstone::proptests::segment_capsule_tests
