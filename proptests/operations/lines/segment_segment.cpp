// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/lines/segment_segment.h"

#include "proptests/forward_error.h"
#include "robust/lines/orientation.h"

namespace touchstone::proptests::segment_segment_tests {
namespace {

using Row = rows::segment_segment;
using Exact = exact_answer_t<Row>;

Exact point(const Rational& ta, const Rational& tb, const Rational& x, const Rational& y) {
  return {SegmentRelation::point, ta, tb, Point2<Rational>{x, y}, {}};
}
Exact overlap(int ax, int ay, int bx, int by) {
  return {SegmentRelation::overlap, {}, {}, {}, Segment2<Rational>{{ax, ay}, {bx, by}}};
}
const Exact disjoint{SegmentRelation::disjoint, {}, {}, {}, {}};

}  // namespace

LAW("segment_segment: a reversed segment has the parameter 1 - t and all else as before", a, b) {
  const auto answer = ask(asked), turned = ask(Row::Question{{a.b, a.a}, b});
  return answer.relation == turned.relation && equal(answer.tb, turned.tb) && equal(answer.point, turned.point) &&
         equal(answer.overlap, turned.overlap) &&
         (a.a == a.b ? equal(answer.ta, turned.ta) : reversed(answer.ta, turned.ta));
}

LAW("segment_segment: a segment meets itself in itself", a) {
  const auto answer = ask(Row::Question{a, a});
  if (a.a == a.b) return answer.relation == SegmentRelation::point && *answer.ta == 0 && *answer.tb == 0;
  if (answer.relation != SegmentRelation::overlap) return false;
  const bool in_order = a.a.x < a.b.x || (a.a.x == a.b.x && a.a.y < a.b.y);
  const Point2d &first = in_order ? a.a : a.b, &last = in_order ? a.b : a.a;
  const auto& [p, q] = *answer.overlap;
  return p.x == first.x && p.y == first.y && q.x == last.x && q.y == last.y;
}

TEST_CASE("segment_segment: p. 12's equations with p. 13's limits worked by hand") {
  // D = A x B, ta = (W x B) / D, tb = (W x A) / D
  example<Row>({{{0, 0}, {4, 4}}, {{0, 4}, {4, 0}}},
               point(Rational(1, 2), Rational(1, 2), 2, 2));  // D -32, W (0, 4): -16, -16
  example<Row>({{{0, 0}, {3, 3}}, {{0, 2}, {2, 0}}},
               point(Rational(1, 3), Rational(1, 2), 1, 1));                           // D -12, W (0, 2): -4, -6
  example<Row>({{{0, 0}, {4, 0}}, {{1, 0}, {1, 5}}}, point(Rational(1, 4), 0, 1, 0));  // D 20, W (1, 0): 5, 0
  example<Row>({{{0, 0}, {1, 1}}, {{3, 0}, {0, 3}}}, disjoint);                        // D 6, W (3, 0): ta = 9 / 6
  example<Row>({{{0, 0}, {1, 1}}, {{0, 1}, {1, 2}}}, disjoint);                        // D 0
}

TEST_CASE("segment_segment: a touch is a point") {
  example<Row>({{{0, 0}, {2, 1}}, {{2, 1}, {3, 5}}}, point(1, 0, 2, 1));  // D 7, W (2, 1): 7, 0
  example<Row>({{{0, 0}, {2, 1}}, {{3, 5}, {0, 0}}}, point(0, 1, 0, 0));
  example<Row>({{{0, 0}, {2, 2}}, {{3, 0}, {1, 1}}}, point(Rational(1, 2), 1, 1, 1));
}

TEST_CASE("segment_segment: collinear segments that share one end meet in a point") {
  example<Row>({{{0, 0}, {2, 2}}, {{2, 2}, {5, 5}}}, point(1, 0, 2, 2), "algorithm");
  example<Row>({{{0, 0}, {2, 0}}, {{-3, 0}, {0, 0}}}, point(0, 1, 0, 0), "algorithm");
  example<Row>({{{-0.0, 0.0}, {1, 0}}, {{-1, -0.0}, {0.0, -0.0}}}, point(0, 1, 0, 0), "algorithm");
}

TEST_CASE("segment_segment: an overlap has its ends in lexicographic order") {
  example<Row>({{{0, 0}, {4, 4}}, {{2, 2}, {6, 6}}}, overlap(2, 2, 4, 4), "algorithm");
  example<Row>({{{4, 4}, {0, 0}}, {{6, 6}, {2, 2}}}, overlap(2, 2, 4, 4), "algorithm");
  example<Row>({{{0, 0}, {9, 0}}, {{5, 0}, {3, 0}}}, overlap(3, 0, 5, 0), "algorithm");
  example<Row>({{{0, 5}, {0, 0}}, {{0, 9}, {0, 3}}}, overlap(0, 3, 0, 5), "algorithm");
  example<Row>({{{7, 1}, {2, 8}}, {{7, 1}, {2, 8}}}, overlap(2, 8, 7, 1), "algorithm");
  example<Row>({{{0, 0}, {1, 1}}, {{2, 2}, {3, 3}}}, disjoint);
}

TEST_CASE("segment_segment: a segment of length zero is a point with parameter 0") {
  example<Row>({{{1, 1}, {1, 1}}, {{1, 1}, {1, 1}}}, point(0, 0, 1, 1), "algorithm");
  example<Row>({{{1, 1}, {1, 1}}, {{1, 2}, {1, 2}}}, disjoint);
  example<Row>({{{0, 0}, {4, 4}}, {{1, 1}, {1, 1}}}, point(Rational(1, 4), 0, 1, 1), "algorithm");
  example<Row>({{{4, 4}, {4, 4}}, {{0, 0}, {4, 4}}}, point(0, 1, 4, 4), "algorithm");
  example<Row>({{{5, 5}, {5, 5}}, {{0, 0}, {4, 4}}}, disjoint);
  example<Row>({{{1, 2}, {1, 2}}, {{0, 0}, {4, 4}}}, disjoint);
}

CONTRACT(
    "segment_segment: the formula in double is right beyond the margin of its contract, its numbers within their "
    "bounds",
    a, b) {
  const Vector2d da = a.b - a.a, db = b.b - b.a, w = b.a - a.a;
  const CrossBound d(da, db, 3);
  const QuotientBound ta(CrossBound(w, db, 3), d), tb(CrossBound(w, da, 3), d);
  if (ta.certainly_outside() || tb.certainly_outside()) {
    return answer.relation == SegmentRelation::disjoint && truth.answer.relation == SegmentRelation::disjoint;
  }
  if (!ta.certainly_inside() || !tb.certainly_inside()) return true;
  return answer.relation == SegmentRelation::point && truth.answer.relation == SegmentRelation::point &&
         within(*answer.ta, *truth.answer.ta, ta.error) && within(*answer.tb, *truth.answer.tb, tb.error);
}

ROBUST_LAW(
    "segment_segment: the formula never answers overlap, and calls collinear contacts disjoint in exact arithmetic", a,
    b) {
  const auto in_exact = [](double number) { return catalogue::Exact(exact(number)); };
  const auto formula = reference::segment_segment(catalogue::converted<catalogue::Exact>(a, in_exact),
                                                  catalogue::converted<catalogue::Exact>(b, in_exact));
  const bool collinear =
      robust::orientation(a.a, a.b, b.a) == Side::on && robust::orientation(a.a, a.b, b.b) == Side::on &&
      robust::orientation(b.a, b.b, a.a) == Side::on && robust::orientation(b.a, b.b, a.b) == Side::on;
  return formula.relation == (collinear ? SegmentRelation::disjoint : ask(asked).relation) ||
         (!collinear && (a.a == a.b || b.a == b.b) && formula.relation == SegmentRelation::disjoint);
}

}  // namespace touchstone::proptests::segment_segment_tests
