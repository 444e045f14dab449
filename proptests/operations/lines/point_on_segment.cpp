// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/lines/point_on_segment.h"

#include "proptests/forward_error.h"
#include "robust/lines/orientation.h"
#include "robust/lines/point_on_segment.h"
#include "robust/lines/segment_segment.h"

namespace touchstone::proptests::point_on_segment_tests {
namespace {

using Row = rows::point_on_segment;

exact_answer_t<Row> on(const Rational& t) { return {Incidence::on, t}; }
const exact_answer_t<Row> off{Incidence::off, std::nullopt};

/// tx or ty of the slide as computed, with the bound e(T) of the contract.
struct Parameter {
  double computed;
  bool defined;
  Rational error;
  Parameter(double to_point, double to_end)
      : computed(to_point / to_end), defined(finite(to_point, to_end, computed) && to_end != 0) {
    if (!defined) return;
    const Rational u = unit();
    error = (3 + 5 * u) * u * size(computed) + power_of_two(-1074);
  }
};

}  // namespace

LAW("point_on_segment: on the reversed segment the point has the parameter 1 - t", p, s) {
  const auto answer = ask(asked), found = ask(Row::Question{p, {s.b, s.a}});
  return found.relation == answer.relation && (s.a == s.b ? equal(answer, found) : reversed(answer.t, found.t));
}

LAW("point_on_segment: both ends are on, at 0 and 1, and no point is off itself", p, s) {
  const auto first = ask(Row::Question{s.a, s}), last = ask(Row::Question{s.b, s}),
             itself = ask(Row::Question{p, {p, p}});
  return first.t && *first.t == 0 && last.t && *last.t == (s.a == s.b ? 0 : 1) && itself.t && *itself.t == 0;
}

ROBUST_LAW("point_on_segment: a point is on a segment exactly if the segment of length zero there meets it in t", p,
           s) {
  const auto answer = ask(asked);
  const auto met = robust::segment_segment({p, p}, s);
  if (answer.relation == Incidence::off) return met.relation == SegmentRelation::disjoint;
  return met.relation == SegmentRelation::point && met.tb == answer.t && *met.point == p &&
         robust::orientation(s.a, s.b, p) == Side::on;
}

TEST_CASE("point_on_segment: p. 11's formula worked by hand") {
  // tx = (x - ax) / (bx - ax), ty = (y - ay) / (by - ay)
  example<Row>({{1, 1}, {{0, 0}, {4, 4}}}, on(Rational(1, 4)));    // 1/4, 1/4
  example<Row>({{1, 2}, {{0, 0}, {3, 6}}}, on(Rational(1, 3)));    // 1/3, 2/6
  example<Row>({{3, -1}, {{5, 1}, {1, -3}}}, on(Rational(1, 2)));  // -2/-4, -2/-4
  example<Row>({{0, 0}, {{0, 0}, {3, 6}}}, on(0));
  example<Row>({{3, 6}, {{0, 0}, {3, 6}}}, on(1));
  example<Row>({{5, 5}, {{0, 0}, {4, 4}}}, off);    // 5/4, 5/4: beyond the end
  example<Row>({{-1, -1}, {{0, 0}, {4, 4}}}, off);  // before the start
  example<Row>({{1, 2}, {{0, 0}, {4, 4}}}, off);    // 1/4, 2/4: beside it
  // The doubles 0.1 and 0.3 are n / 2^55 and (3n - 1) / 2^55 with n = 3602879701896397.
  example<Row>({{0.1, 0.1}, {{0, 0}, {0.3, 0.3}}}, on(Rational("3602879701896397/10808639105689190")));
}

TEST_CASE("point_on_segment: parallel to an axis or of length zero the slide's quotient is 0 / 0") {
  example<Row>({{1, 0}, {{0, 0}, {4, 0}}}, on(Rational(1, 4)), "algorithm");
  example<Row>({{7, 2}, {{7, 0}, {7, 6}}}, on(Rational(1, 3)), "algorithm");
  example<Row>({{4, 0}, {{0, 0}, {4, 0}}}, on(1), "algorithm");
  example<Row>({{5, 0}, {{0, 0}, {4, 0}}}, off);
  example<Row>({{1, 1}, {{0, 0}, {4, 0}}}, off);
  example<Row>({{2, 3}, {{2, 3}, {2, 3}}}, on(0), "algorithm");
  example<Row>({{2, 4}, {{2, 3}, {2, 3}}}, off);
  example<Row>({{3, 4}, {{2, 3}, {2, 3}}}, off);
}

CONTRACT("point_on_segment: the formula in double is rightly off beyond the margin of its contract", p, s) {
  const Parameter tx(p.x - s.a.x, s.b.x - s.a.x), ty(p.y - s.a.y, s.b.y - s.a.y);
  bool certain = tx.defined && ty.defined && abs(exact(tx.computed) - exact(ty.computed)) > tx.error + ty.error;
  if (tx.defined && ty.defined)
    certain = certain || exact(tx.computed) < -tx.error || exact(tx.computed) > 1 + tx.error;
  return !certain || (truth.answer.relation == Incidence::off && answer.relation == Incidence::off);
}

CONTRACT("point_on_segment: where the formula is rightly on, its t is within the bound of its contract", p, s) {
  if (answer.relation == Incidence::off || truth.answer.relation == Incidence::off) return true;
  const Parameter tx(p.x - s.a.x, s.b.x - s.a.x);
  return !tx.defined || within(*answer.t, *truth.answer.t, tx.error);
}

ROBUST_LAW("point_on_segment: along an axis the formula is off even in exact arithmetic", p, s) {
  if (s.a.x != s.b.x && s.a.y != s.b.y) return true;
  const auto in_exact = [](double number) { return catalogue::Exact(exact(number)); };
  return reference::point_on_segment(catalogue::converted<catalogue::Exact>(p, in_exact),
                                     catalogue::converted<catalogue::Exact>(s, in_exact))
             .relation == Incidence::off;
}

}  // namespace touchstone::proptests::point_on_segment_tests
