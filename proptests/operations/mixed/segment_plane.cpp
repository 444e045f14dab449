// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/segment_plane.h"

#include "proptests/ray_laws.h"

namespace touchstone::proptests::segment_plane_tests {

using Row = rows::segment_plane;
using namespace plane_passages;

constexpr Worked<Row> worked;

PLANE_PASSAGE_LAWS("segment_plane")

LAW("segment_plane: the reversed segment has the same in common", segment, plane) {
  const auto answer = ask(asked), found = ask(Row::Question{{segment.b, segment.a}, plane});
  return answer.relation == found.relation && reversed(answer.t, found.t) && equal(answer.point, found.point);
}

LAW("segment_plane: its ends alone are inside exactly where the segment is, or meets the plane there", segment, plane) {
  const auto answer = ask(asked);
  const auto meets = [&](const Point3d& p) { return ask(Row::Question{{p, p}, plane}).relation == Relation::inside; };
  const bool a = meets(segment.a), b = meets(segment.b);
  if (answer.relation != Relation::point) return (a && b) == (answer.relation == Relation::inside) && a == b;
  return !(a && b) && (!a || *answer.t == 0) && (!b || *answer.t == 1);
}

TEST_CASE("segment_plane: E0 / (E0 - E1) worked by hand; margin: the nearer end") {
  worked({{{0, 3, 0}, {4, -1, 8}}, ground}, at(Rational(3, 4), {3, 0, 6}), 1);
  worked({{{4, -1, 8}, {0, 3, 0}}, ground}, at(Rational(1, 4), {3, 0, 6}), 1);  // from behind
  worked({{{1, 2, 0}, {4, -4, 3}}, ground}, at(Rational(1, 3), {2, 0, 1}), 4);
  worked({{{3, 3, 3}, {3, 3, -3}}, {{2, 1, 2}, -9}}, at(Rational(1, 2), {3, 3, 0}), 4);  // 6 of length 3 from either
  worked({{{0, 3, 0}, {4, 1, 8}}, ground}, none, 1);                                     // 3 / 2
  worked({{{0, -2, 0}, {4, -1, 8}}, ground}, none, 1);
  worked({{{0, 1, 0}, {4, 1, 8}}, ground}, none, 1);  // 1 / 0
}

TEST_CASE("segment_plane: an end on the plane is a point, all of it is inside") {
  worked({{{7, 0, 0}, {4, 1, 8}}, ground}, at(0, {7, 0, 0}), 0);
  worked({{{7, 0, 0}, {4, -1, 8}}, ground}, at(0, {7, 0, 0}), 0);
  worked({{{1, 2, 0}, {5, 0, 4}}, ground}, at(1, {5, 0, 4}), 0);
  worked({{{1, 0, 0}, {2, 0, 0}}, ground}, inside, 0, "algorithm");  // 0 / 0
  worked({{{1, 0, 2}, {1, 0, 2}}, ground}, inside, 0, "algorithm");
  worked({{{1, 3, 2}, {1, 3, 2}}, ground}, none, 9);
}

TEST_CASE("segment_plane: rounding meets a plane that the segment does not reach, and misses one that it does") {
  worked({{{0, 0x1p60, 0}, {0, 1, 0}}, ground}, none, 1, "rounding");  // 2^60 - 1 rounds to 2^60: t = 1
  // 10 times the double 0.1 is 1 + 2^-54, which rounds to 1: on the plane, says E1.
  worked({{{1, 0, 0}, {0.1, 0, 0}}, {{10, 0, 0}, -1}}, none, power_of_two(-108) / 100, "rounding");
}

CONTRACT("segment_plane: the formula in double keeps its contract", segment, plane) {
  const auto& [a, b] = segment;
  const HeightBound first(plane, a), last(plane, b);
  if (!first.certain() || !last.certain()) return true;
  const Rational u = unit(), e0 = exact(first.computed), e1 = exact(last.computed);
  const double difference = first.computed - last.computed;
  if (sgn(e0) == sgn(e1)) {
    if (!(abs(e1) > last.error + 2 * u * abs(e0)) || !(abs(e0) > power_of_two(-1074) * abs(e0 - e1))) return true;
    return answer.relation == Relation::none && truth.answer.relation == Relation::none;
  }
  if (!finite(difference)) return true;
  if (answer.relation != Relation::point || truth.answer.relation != Relation::point) return false;
  const Rational gap = size(difference), f = first.error + last.error + u * gap, t = exact(*answer.t);
  if (!(f < gap)) return true;
  const Rational error = (first.error + t * f) / (gap - f) + 2 * u * t + power_of_two(-1074);
  const auto close = [&](double from, double to, double computed, const Rational& right) {
    const double v = to - from;
    if (!finite(v, *answer.t * v, computed)) return true;
    return within(computed, right,
                  (1 + 2 * u) * size(v) * error + 3 * u * t * size(v) + u * size(computed) + power_of_two(-1073));
  };
  const auto& p = *answer.point;
  const auto& q = *truth.answer.point;
  return within(*answer.t, *truth.answer.t, error) && close(a.x, b.x, p.x, q.x) && close(a.y, b.y, p.y, q.y) &&
         close(a.z, b.z, p.z, q.z);
}

}  // namespace touchstone::proptests::segment_plane_tests
