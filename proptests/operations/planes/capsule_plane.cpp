// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/planes/capsule_plane.h"

#include "proptests/half_space_laws.h"
#include "robust/mixed/aabb_plane.h"
#include "robust/mixed/sphere_plane.h"

namespace touchstone::proptests::capsule_plane_tests {
namespace {

using Row = rows::capsule_plane;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;

/// From one height to another.
Row::Question over_ground(double from, double to, double radius) {
  return {{{{3, from, -1}, {7, to, 2}}, radius}, ground};
}
bool is_segment(const Capsule3d& capsule) { return capsule.radius == 0; }

constexpr Worked<Row> worked;

}  // namespace

HALF_SPACE_LAWS("capsule_plane", is_segment)

LAW("capsule_plane: the ends may be exchanged", capsule, plane) {
  const auto& [a, b] = capsule.segment;
  return ask(Row::Question{{{b, a}, capsule.radius}, plane}) == ask(asked);
}

LAW("capsule_plane: a capsule that grows never loses contact, and one that touched overlaps", capsule, plane) {
  if (capsule.radius == greatest) return true;
  const Contact then = ask(Row::Question{{capsule.segment, catalogue::moved_by_ulps(capsule.radius, 1)}, plane});
  return ask(asked) == disjoint || then == overlapping;
}

ROBUST_LAW("capsule_plane: a capsule has at least the contact of a ball around a point of its segment", capsule,
           plane) {
  const auto& [a, b] = capsule.segment;
  const Contact contact = ask(asked), at_a = robust::sphere_plane({a, capsule.radius}, plane);
  if (contact < at_a || (a == b && contact != at_a)) return false;
  const Point3d middle{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
  return !on_lattice(asked) || contact >= robust::sphere_plane({middle, capsule.radius}, plane);
}

ROBUST_LAW("capsule_plane: a segment along an axis has the contact of a flat box", capsule, plane) {
  const auto& [a, b] = capsule.segment;
  const Point3d end{std::max(a.x, b.x), a.y, a.z}, start{std::min(a.x, b.x), a.y, a.z};
  return ask(Row::Question{{{end, start}, 0}, plane}) == robust::aabb_plane({start, end}, plane);
}

TEST_CASE("capsule_plane: heights and radii worked by hand") {
  worked(over_ground(5, 9, 2), disjoint, 21);      // 5^2 - 2^2
  worked(over_ground(9, 2, 2), touching, 0);       // it reaches the ground with an end
  worked(over_ground(2, 2, 2), touching, 0);       // and along its side
  worked(over_ground(1, 7, 2), overlapping, 3);    // 2^2 - 1^2
  worked(over_ground(8, -1, 2), overlapping, 4);   // its segment crosses the plane
  worked(over_ground(-2, -9, 2), overlapping, 4);  // touches the plane from behind: its radius may become 0
  worked(over_ground(3, 3, 0), disjoint, 9);
  // E = 18 and 27 of length 3 |N|: 6 and 9 away.
  worked({{{{3, 6, 6}, {4, 8, 8}}, 6}, {{1, 2, 2}, -9}}, touching, 0);
  // E = 3, |N| = sqrt(2): 9 / 2 against r^2.
  worked({{{{3, 0, 0}, {3, 1, 5}}, 2}, {{1, 1, 0}, 0}}, disjoint, Rational(1, 2));
  worked({{{{3, 0, 0}, {3, 0, 0}}, 3}, {{1, 1, 0}, 0}}, overlapping, Rational(9, 2));
}

TEST_CASE("capsule_plane: a segment only touches; the formula sees an overlap behind the plane") {
  worked(over_ground(0, 3, 0), touching, 0);
  worked(over_ground(3, -3, 0), touching, 0, "algorithm");
  worked(over_ground(-tiny, 0, -0.0), touching, 0, "algorithm");
}

TEST_CASE("capsule_plane: rounding, huge, subnormal and negative zero") {
  // 1 + 2^-60 high, radius 1.
  worked({{{{1, 0, 0}, {2, 0, 0}}, 1}, {{1, 0, 0}, 0x1p-60}}, disjoint,
         Rational(power_of_two(-59) + power_of_two(-120)), "rounding");
  worked(over_ground(2 * tiny, huge, tiny), disjoint, Rational(3 * exact(tiny) * exact(tiny)));
  worked(over_ground(huge, huge, huge), touching, 0);
  worked({{{{0, 3, 0}, {0, 4, 0}}, 3}, {{0, tiny, 0}, 0}}, touching, 0, "rounding");  // |N| is 0
  worked({{{{-0.0, -0.0, 0}, {0, 0, 0}}, -0.0}, {{-0.0, 1, 0}, -0.0}}, touching, 0);
}

TEST_CASE("capsule_plane: numbers are refused first, then the radius, then the normal") {
  const Segment3d segment{{0, 0, 0}, {1, 0, 0}};
  refused<Row>({{segment, -1}, {{infinity, 0, 0}, 0}}, "plane.normal[0]", "finite number");
  refused<Row>({{segment, -1}, {{0, 0, 0}, 0}}, "capsule.radius", "radius >= 0");
  refused<Row>({{segment, 1}, {{0, -0.0, 0}, 0}}, "plane.normal", "nonzero normal");
}

CONTRACT("capsule_plane: the formula in double keeps its contract", capsule, plane) {
  const auto& [a, b] = capsule.segment;
  return keeps_contract_over_plane({a, b}, capsule.radius, plane, answer, truth.answer);
}

}  // namespace touchstone::proptests::capsule_plane_tests
