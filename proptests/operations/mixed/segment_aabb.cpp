// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/segment_aabb.h"

#include "proptests/passage_laws.h"
#include "robust/sweeps/swept_aabb_aabb.h"
#include "robust/volumes/aabb_aabb.h"

namespace touchstone::proptests::segment_aabb_tests {

using Row = rows::segment_aabb;
using InPlane = Row::InPlane;
using InSpace = Row::InSpace;
using namespace passages;

constexpr Worked<Row> worked;
constexpr Aabb2d square{{0, 0}, {4, 4}};
constexpr Aabb3d cube{{0, 0, 0}, {4, 4, 4}};

AABB_PASSAGE_LAWS("segment_aabb", "segment")
REVERSED_PASSAGE_LAW("segment_aabb")

ROBUST_LAW("segment_aabb: first is 0 and last is 1 where aabb_aabb sees the ends in the box", segment, box) {
  const auto meets = [&box = box](const auto& p) {
    return robust::aabb_aabb(std::decay_t<decltype(box)>{p, p}, box) != Contact::disjoint;
  };
  const auto answer = ask(asked);
  const bool a = meets(segment.a), b = meets(segment.b);
  if (segment.a == segment.b) return a ? answer.last == 0.0 : answer.relation == Relation::none;
  return (!a || answer.first == 0.0) && (!b || answer.last == 1.0);
}

ROBUST_LAW("segment_aabb: on the lattice a point that moves along the segment meets the box first at first", segment,
           box) {
  if (!on_lattice(asked)) return true;
  const auto swept = robust::swept_aabb_aabb({segment.a, segment.a}, box, segment.b - segment.a);
  const auto answer = ask(asked);
  return (swept.relation == HitRelation::hit) == (answer.relation == Relation::hit) && swept.t == answer.first;
}

TEST_CASE("segment_aabb: entries and exits worked by hand, and how far it has to be moved to miss or to meet") {
  // x: from 2 / 8 to 6 / 8; y: from -1 / 4 to 3 / 4. Moved by 4 / 3 on both axes, x from and y until 5 / 12.
  worked(InPlane{{{-2, 1}, {6, 5}}, square}, from_to(Rational(1, 4), Rational(3, 4)), Rational(4, 3));
  // x: from -1 to 3; y: from -1 / 2 to 3 / 2. Moved by 5 / 3, x from and y until 2 / 3.
  worked(InPlane{{{1, 1}, {2, 3}}, square}, from_to(0, 1), Rational(5, 3));
  worked(InPlane{{{-2, 1}, {2, 1}}, square}, from_to(Rational(1, 2), 1), 1);
  worked(InPlane{{{-2, 1}, {-1, 1}}, square}, none, 1);  // ends before it
  worked(InPlane{{{-2, 5}, {9, 5}}, square}, none, 1);   // beside it
  worked(InPlane{{{-2, 3}, {2, 7}}, square}, none, Rational(1, 2));
  worked(InSpace{{{1, 2, 9}, {1, 2, -1}}, cube}, from_to(Rational(1, 2), Rational(9, 10)), 1);
}

TEST_CASE("segment_aabb: touching is a hit: by a corner, along a face or an edge, at an end") {
  worked(InPlane{{{-2, 2}, {2, 6}}, square}, from_to(Rational(1, 2), Rational(1, 2)), 0);
  worked(InPlane{{{-2, 4}, {6, 4}}, square}, from_to(Rational(1, 4), Rational(3, 4)), 0);
  worked(InSpace{{{-2, 4, 4}, {6, 4, 4}}, cube}, from_to(Rational(1, 4), Rational(3, 4)), 0);
  worked(InPlane{{{-2, 1}, {0, 2}}, square}, from_to(1, 1), 0);
  worked(InPlane{{{4, 1}, {5, 2}}, square}, from_to(0, 0), 0);
}

TEST_CASE("segment_aabb: a segment of length zero is a point, flat boxes and points are met") {
  worked(InPlane{{{1, 1}, {1, 1}}, square}, from_to(0, 0), 1, "algorithm");
  worked(InPlane{{{4, 1}, {4, 1}}, square}, from_to(0, 0), 0, "algorithm");
  worked(InPlane{{{5, 1}, {5, 1}}, square}, none, 1);
  worked(InPlane{{{-2, 0}, {2, 2}}, {{0, 0}, {0, 4}}}, from_to(Rational(1, 2), Rational(1, 2)), Rational(2, 3));
  worked(InPlane{{{0, 0}, {0, 4}}, {{0, 1}, {0, 3}}}, from_to(Rational(1, 4), Rational(3, 4)), 0);
  worked(InPlane{{{1, 1}, {1, 1}}, {{1, 1}, {1, 1}}}, from_to(0, 0), 0, "algorithm");
}

TEST_CASE("segment_aabb: rounding moves an entry to an exit") {
  // x: from (1 + 2^-60) / (4 + 2^-60), y: until 1 / 4; both are 1 / 4 in double.
  const Rational hair = power_of_two(-60);
  worked(InPlane{{{-0x1p-60, 0}, {4, 4}}, {{1, -1}, {2, 1}}}, none, Rational(3 * hair / (8 + hair)), "rounding");
}

}  // namespace touchstone::proptests::segment_aabb_tests
