// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/planes/point_plane_toi.h"

#include "proptests/space_laws.h"
#include "robust/planes/point_plane.h"

namespace touchstone::proptests::point_plane_toi_tests {
namespace {

using Row = rows::point_plane_toi;
using Answer = exact_answer_t<Row>;

constexpr HitRelation hit = HitRelation::hit, misses = HitRelation::never;

Answer at(HitRelation option_1, const Rational& t, const Point3<Rational>& point) {
  return {{option_1}, {hit, t, point}};
}
const Answer in_front{{misses}, {misses, std::nullopt, std::nullopt}};

const Plane3d ground{{0, 1, 0}, 0};

}  // namespace

ROBUST_LAW("point_plane_toi: the relations are the sides of the two ends", plane, start, end) {
  const auto answer = ask(asked);
  const bool starts = robust::point_plane_side(plane, start) != PlaneSide::front,
             ends = robust::point_plane_side(plane, end) != PlaneSide::front;
  return (answer.option_1.relation == hit) == ends && (answer.option_2.relation == hit) == (starts || ends);
}

LAW("point_plane_toi: option 2 finds whatever option 1 finds, at t in [0, 1]; at rest they agree", plane, start, end) {
  const auto answer = ask(asked), rest = ask(Row::Question{plane, end, end});
  const auto& t = answer.option_2.t;
  return (answer.option_1.relation == misses || answer.option_2.relation == hit) && (!t || (*t >= 0 && *t <= 1)) &&
         rest.option_1.relation == rest.option_2.relation && rest.option_1.relation == answer.option_1.relation &&
         (!rest.option_2.t || *rest.option_2.t == 0);
}

TEST_CASE("point_plane_toi: the exact point of contact is on the plane, the start itself, or behind") {
  law_of<Row>(
      "oracle: the point", [](const auto& asked) { return catalogue::ask_oracle<Row>(asked).answer; },
      [](const auto& ask, const auto& asked) {
        const auto& [plane, start, end] = asked;
        const auto first = ask(asked).option_2;
        if (!first.t) return true;
        const auto& p = *first.point;
        const Rational e = exact(plane.normal.x) * p.x + exact(plane.normal.y) * p.y + exact(plane.normal.z) * p.z +
                           exact(plane.offset);
        return *first.t == 0 ? sgn(e) <= 0 && p.x == exact(start.x) && p.y == exact(start.y) && p.z == exact(start.z)
                             : sgn(e) == 0;
      },
      3);
}

LAW("point_plane_toi: backwards through the plane turned over the same point is met at 1 - t", plane, start, end) {
  const auto answer = ask(asked), back = ask(Row::Question{{-1.0 * plane.normal, -plane.offset}, end, start});
  if (answer.option_1.relation == misses || (answer.option_2.t && *answer.option_2.t == 0)) return true;
  return equal(back.option_2.point, answer.option_2.point) && reversed(answer.option_2.t, back.option_2.t);
}

EQUATION_LAW("point_plane_toi", 0)

LAW("point_plane_toi: exchanges of the axes exchange the point's coordinates") {
  const auto answer = ask(asked);
  return std::all_of(axis_maps.begin(), axis_maps.end(),
                     [&](const AxisMap& map) { return equal(ask(map(asked)), map(answer)); });
}

LAW("point_plane_toi: lengths times a power of two keep t and the relations, and move the point with them") {
  const auto answer = ask(asked);
  for (const int k : {1, -29, 300, -300, 1000, -1000}) {
    auto larger = asked;
    Row::scale(larger, k);
    auto back = larger;
    Row::scale(back, -k);
    if (numbers_of(back) != numbers_of(asked)) continue;
    const auto found = ask(larger);
    const auto &p = answer.option_2.point, &q = found.option_2.point;
    if (found.option_1.relation != answer.option_1.relation || found.option_2.relation != answer.option_2.relation)
      return false;
    if (!equal(found.option_2.t, answer.option_2.t) || p.has_value() != q.has_value()) return false;
    if (p && !(scaled_number(p->x, q->x, k) && scaled_number(p->y, q->y, k) && scaled_number(p->z, q->z, k)))
      return false;
  }
  return true;
}

TEST_CASE("point_plane_toi: p. 23's E0 / (E0 - E1) worked by hand") {
  example<Row>({ground, {0, 3, 0}, {4, -1, 8}}, at(hit, Rational(3, 4), {3, 0, 6}));           // 3 / (3 + 1)
  example<Row>({ground, {1, 2, 0}, {4, -4, 3}}, at(hit, Rational(1, 3), {2, 0, 1}));           // 2 / (2 + 4)
  example<Row>({{{2, 1, 2}, -9}, {3, 3, 3}, {3, 3, -3}}, at(hit, Rational(1, 2), {3, 3, 0}));  // 6 / (6 + 6)
  example<Row>({ground, {1, 2, 0}, {5, 0, 4}}, at(hit, 1, {5, 0, 4}));                         // 2 / (2 - 0)
  example<Row>({ground, {0, 3, 0}, {4, 1, 8}}, in_front);                                      // 3 / (3 - 1) > 1
  example<Row>({ground, {0, 1, 0}, {4, 3, 8}}, in_front);                                      // 1 / (1 - 3) < 0
  example<Row>({ground, {0, 1, 0}, {4, 1, 8}}, in_front);                                      // 1 / 0
  example<Row>({ground, {0, 0, 0}, {4, -1, 8}}, at(hit, 0, {0, 0, 0}));
  example<Row>({ground, {7, 0, 0}, {4, 1, 8}}, at(misses, 0, {7, 0, 0}));  // option 1 misses the contact at the start
}

TEST_CASE("point_plane_toi: from behind, in the plane and at rest the slide's formula fails") {
  example<Row>({ground, {1, -1, 0}, {1, -2, 0}}, at(hit, 0, {1, -1, 0}), "algorithm");    // -1 / 1
  example<Row>({ground, {1, -2, 0}, {1, -1, 0}}, at(hit, 0, {1, -2, 0}), "algorithm");    // 2
  example<Row>({ground, {1, -1, 0}, {1, 1, 0}}, at(misses, 0, {1, -1, 0}), "algorithm");  // 1/2, where it leaves
  example<Row>({ground, {1, -1, 0}, {1, 0, 0}}, at(hit, 0, {1, -1, 0}), "algorithm");     // 1
  example<Row>({ground, {1, 0, 0}, {2, 0, 0}}, at(hit, 0, {1, 0, 0}), "algorithm");       // 0 / 0
  example<Row>({ground, {1, 0, 2}, {1, 0, 2}}, at(hit, 0, {1, 0, 2}), "algorithm");       // 0 / 0
  example<Row>({ground, {1, -3, 2}, {1, -3, 2}}, at(hit, 0, {1, -3, 2}), "algorithm");    // -3 / 0
  example<Row>({ground, {1, 3, 2}, {1, 3, 2}}, in_front);
}

TEST_CASE("point_plane_toi: rounding hits a plane that the step does not reach, and misses one that it does") {
  example<Row>({ground, {0, 0x1p60, 0}, {0, 1, 0}}, in_front, "rounding");  // 2^60 - 1 rounds to 2^60: t = 1
  // 10 times the double 0.1 is 1 + 2^-54, which rounds to 1: on the plane, says E1.
  example<Row>({{{10, 0, 0}, -1}, {1, 0, 0}, {0.1, 0, 0}}, in_front, "rounding");
  example<Row>({{{-10, 0, 0}, 1}, {0.1, 0, 0}, {0, 0, 0}}, at(misses, 0, {catalogue::exact_value(0.1), 0, 0}));
}

CONTRACT("point_plane_toi: the formula in double keeps its contract", plane, start, end) {
  const HeightBound first(plane, start), last(plane, end);
  if (first.overflow || last.overflow) return true;
  const Rational u = unit(), e0 = exact(first.computed), e1 = exact(last.computed);
  if (last.certain() && answer.option_1.relation != truth.answer.option_1.relation) return false;
  if (!(e0 > first.error)) return true;
  const double difference = first.computed - last.computed, t = first.computed / difference;
  if (e1 > last.error + 2 * u * e0 && e0 > power_of_two(-1074) * abs(e0 - e1))
    return answer.option_2.relation == misses && truth.answer.option_2.relation == misses;
  if (!(e1 < -last.error)) return true;
  if (answer.option_2.relation != hit || truth.answer.option_2.relation != hit) return !finite(difference);
  if (!finite(difference)) return true;
  const Rational gap = exact(difference), f = first.error + last.error + u * gap;
  if (!(f < gap)) return true;
  const Rational error = (first.error + exact(t) * f) / (gap - f) + 2 * u * exact(t) + power_of_two(-1074);
  if (!within(*answer.option_2.t, *truth.answer.option_2.t, error)) return false;
  const auto close = [&](double from, double to, double computed, const Rational& right) {
    const double v = to - from;
    if (!finite(v, t * v, computed)) return true;
    return within(
        computed, right,
        (1 + 2 * u) * size(v) * error + 3 * u * exact(t) * size(v) + u * size(computed) + power_of_two(-1073));
  };
  const auto& p = *answer.option_2.point;
  const auto& q = *truth.answer.option_2.point;
  return close(start.x, end.x, p.x, q.x) && close(start.y, end.y, p.y, q.y) && close(start.z, end.z, p.z, q.z);
}

}  // namespace touchstone::proptests::point_plane_toi_tests
