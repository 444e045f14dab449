// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/lines/line_line.h"

#include "proptests/forward_error.h"

namespace touchstone::proptests::line_line_tests {
namespace {

using Row = rows::line_line;

exact_answer_t<Row> crossing(const Rational& ta, const Rational& tb, const Rational& x, const Rational& y) {
  return {LineRelation::crossing, ta, tb, Point2<Rational>{x, y}};
}
const exact_answer_t<Row> parallel{LineRelation::parallel, {}, {}, {}}, same{LineRelation::same, {}, {}, {}};

}  // namespace

LAW("line_line: on a line given from q to p the crossing has the parameter 1 - t", a, b) {
  const auto answer = ask(asked), a_turned = ask(Row::Question{{a.q, a.p}, b}),
             b_turned = ask(Row::Question{a, {b.q, b.p}});
  return answer.relation == a_turned.relation && answer.relation == b_turned.relation &&
         equal(answer.tb, a_turned.tb) && equal(answer.ta, b_turned.ta) && equal(answer.point, a_turned.point) &&
         equal(answer.point, b_turned.point) && reversed(answer.ta, a_turned.ta) && reversed(answer.tb, b_turned.tb);
}

LAW("line_line: a line is the same as itself, whichever way it is given", a) {
  return ask(Row::Question{a, a}).relation == LineRelation::same &&
         ask(Row::Question{a, {a.q, a.p}}).relation == LineRelation::same;
}

TEST_CASE("line_line: p. 12's equations worked by hand") {
  // D = A x B, ta = (W x B) / D, tb = (W x A) / D
  example<Row>({{{0, 0}, {4, 4}}, {{0, 4}, {4, 0}}},
               crossing(Rational(1, 2), Rational(1, 2), 2, 2));                            // D -32, W (0, 4): -16, -16
  example<Row>({{{0, 0}, {1, 0}}, {{3, -1}, {3, 2}}}, crossing(3, Rational(1, 3), 3, 0));  // D 3, W (3, -1): 9, 1
  example<Row>({{{1, 1}, {2, 3}}, {{0, 4}, {1, 4}}},
               crossing(Rational(3, 2), Rational(5, 2), Rational(5, 2), 4));  // D -2: -3, -5
  example<Row>({{{0, 0}, {1, 1}}, {{0, 1}, {1, 2}}}, parallel);
  example<Row>({{{0, 0}, {0, 1}}, {{5, 7}, {5, -7}}}, parallel);
}

TEST_CASE("line_line: the slide has no case for two lines that are one") {
  example<Row>({{{0, 0}, {1, 1}}, {{2, 2}, {5, 5}}}, same, "algorithm");
  example<Row>({{{0, 3}, {1, 3}}, {{9, 3}, {-9, 3}}}, same, "algorithm");
}

TEST_CASE("line_line: nearly parallel, huge, subnormal, beyond the range, negative zero") {
  example<Row>({{{0, 0}, {1, 1}}, {{0, 0}, {1, 1 + 0x1p-52}}}, crossing(0, 0, 0, 0));
  example<Row>({{{-0.0, 0.0}, {1, -0.0}}, {{0.0, -0.0}, {-0.0, 1}}}, crossing(0, 0, 0, 0));
  // The differences overflow and their quotients are NaN.
  example<Row>({{{-huge, 0}, {huge, 0}}, {{0, -huge}, {0, huge}}}, crossing(Rational(1, 2), Rational(1, 2), 0, 0),
               "invalid");
  // D underflows to 0.
  example<Row>({{{0, 0}, {tiny, 0}}, {{0, 0}, {0, tiny}}}, crossing(0, 0, 0, 0), "rounding");
  // b falls by 2^-53 over its width: it meets the x axis at 2^53 widths, whose nearest double is infinity.
  const Rational far = Rational(catalogue::exact_value(huge) * catalogue::exact_value(0x1p53));
  example<Row>({{{0, 0}, {1, 0}}, {{0, 1}, {huge, 1 - 0x1p-53}}}, crossing(far, catalogue::exact_value(0x1p53), far, 0),
               "invalid");
}

CONTRACT("line_line: the formula in double is right beyond the margin of its contract, its numbers within their bounds",
         a, b) {
  const Vector2d da = a.q - a.p, db = b.q - b.p, w = b.p - a.p;
  const CrossBound d(da, db, 3), na(w, db, 3), nb(w, da, 3);
  if (d.overflow || *truth.margin <= d.before) return true;
  if (answer.relation != LineRelation::crossing || truth.answer.relation != LineRelation::crossing) return false;
  const QuotientBound ta(na, d), tb(nb, d);
  if (ta.defined && !within(*answer.ta, *truth.answer.ta, ta.error)) return false;
  if (tb.defined && !within(*answer.tb, *truth.answer.tb, tb.error)) return false;
  const auto coordinate_kept = [&](double origin, double step, double computed, const Rational& exactly) {
    const double product = ta.computed * step, sum = origin + product;
    if (!ta.defined || !finite(product, sum)) return true;
    const Rational u = unit();
    const Rational bound =
        (1 + u) * size(step) * ta.error + (2 + 2 * u) * u * size(product) + u * size(sum) + power_of_two(-1074);
    return within(computed, exactly, bound);
  };
  return coordinate_kept(a.p.x, da.x, answer.point->x, truth.answer.point->x) &&
         coordinate_kept(a.p.y, da.y, answer.point->y, truth.answer.point->y);
}

}  // namespace touchstone::proptests::line_line_tests
