// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/ray_aabb.h"

#include "proptests/passage_laws.h"
#include "robust/mixed/segment_aabb.h"
#include "robust/volumes/aabb_aabb.h"

namespace touchstone::proptests::ray_aabb_tests {

using Row = rows::ray_aabb;
using InPlane = Row::InPlane;
using InSpace = Row::InSpace;
using namespace passages;

constexpr Worked<Row> worked;
constexpr Aabb2d square{{0, 0}, {4, 4}};
constexpr Aabb3d cube{{0, 0, 0}, {4, 4, 4}};

AABB_PASSAGE_LAWS("ray_aabb", "ray")
DIRECTION_PASSAGE_LAW("ray_aabb")

ROBUST_LAW("ray_aabb: first is 0 where aabb_aabb sees the origin in the box, and only where t underflows else", ray,
           box) {
  const bool within = robust::aabb_aabb(std::decay_t<decltype(box)>{ray.origin, ray.origin}, box) != Contact::disjoint;
  const auto answer = ask(asked);
  return !within || (answer.relation == Relation::hit && *answer.first == 0);
}

ROBUST_LAW("ray_aabb: on the lattice a ray meets what the segment of its direction meets", ray, box) {
  if (!on_lattice(asked)) return true;
  const auto answer = ask(asked), part = robust::segment_aabb({ray.origin, ray.origin + ray.direction}, box);
  if (part.relation == Relation::none) return answer.relation == Relation::none || *answer.first >= 1;
  return answer.first == part.first && std::min(*answer.last, 1.0) == *part.last;
}

TEST_CASE("ray_aabb: entries and exits worked by hand, and how far the ray has to be moved to miss or to meet") {
  // x: from 2 / 2 to 6 / 2; y: from -1 to 3. Moved by 4 / 3 on both axes, x from and y until 5 / 3.
  worked(InPlane{{{-2, 1}, {2, 1}}, square}, from_to(1, 3), Rational(4, 3));
  // x: from -1 / 2 to 3 / 2; y: from -1 to 3. Moved by 5 / 3, x until and y from 2 / 3.
  worked(InPlane{{{1, 1}, {2, 1}}, square}, from_to(0, Rational(3, 2)), Rational(5, 3));
  worked(InPlane{{{-2, 1}, {-2, 1}}, square}, none, 2);  // away
  worked(InPlane{{{-2, 5}, {1, 0}}, square}, none, 1);   // beside it
  // x: from 2; y: until 1. Moved by 1 / 2, x from 3 / 2 and y until 3 / 2.
  worked(InPlane{{{-2, 3}, {1, 1}}, square}, none, Rational(1, 2));
  worked(InSpace{{{1, 2, 9}, {0, 0, -2}}, cube}, from_to(Rational(5, 2), Rational(9, 2)), 1);
}

TEST_CASE("ray_aabb: touching is a hit: by a corner, along a face or an edge, from the boundary") {
  worked(InPlane{{{-2, 2}, {1, 1}}, square}, from_to(2, 2), 0);         // by the corner (0, 4)
  worked(InPlane{{{-2, 4}, {1, 0}}, square}, from_to(2, 6), 0);         // along y = 4
  worked(InSpace{{{-2, 4, 4}, {1, -0.0, 0}}, cube}, from_to(2, 6), 0);  // along an edge
  worked(InPlane{{{0, 1}, {-1, 0}}, square}, from_to(0, 0), 0);         // away from x = 0
  worked(InPlane{{{0, 1}, {1, 0}}, square}, from_to(0, 4), 1);          // into it, 1 above y = 0
  worked(InPlane{{{4, 1}, {0, 1}}, square}, from_to(0, 3), 0);          // along x = 4
}

TEST_CASE("ray_aabb: flat boxes and points are met") {
  worked(InPlane{{{-2, 0}, {2, 1}}, {{0, 0}, {0, 4}}}, from_to(1, 1), Rational(2, 3));  // x until, y from 2 / 3
  worked(InPlane{{{-2, 0}, {2, 1}}, {{0, 1}, {0, 1}}}, from_to(1, 1), 0);
  worked(InPlane{{{0, 0}, {0, 1}}, {{0, 1}, {0, 3}}}, from_to(1, 3), 0);
  worked(InPlane{{{-2, 0}, {2, 1}}, {{0, 2}, {0, 2}}}, none, Rational(2, 3));
}

TEST_CASE("ray_aabb: rounding moves an entry to an exit") {
  // x: from (1 + 2^-60) / 4, which is 1 / 4 in double; y: until 1 / 4.
  worked(InPlane{{{-0x1p-60, 0}, {4, 4}}, {{1, -1}, {2, 1}}}, none, power_of_two(-61), "rounding");
}

TEST_CASE("ray_aabb: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::ray_aabb_tests
