// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/lines/ray_segment.h"

#include "proptests/forward_error.h"
#include "robust/lines/ray_segment.h"
#include "robust/lines/segment_segment.h"

namespace touchstone::proptests::ray_segment_tests {
namespace {

using Row = rows::ray_segment;
using Exact = exact_answer_t<Row>;

Exact point(const Rational& t, const Rational& x, const Rational& y) {
  return {RayRelation::point, t, Point2<Rational>{x, y}, {}};
}
Exact overlap(const Rational& t, int ax, int ay, int bx, int by) {
  return {RayRelation::overlap, t, {}, Segment2<Rational>{{ax, ay}, {bx, by}}};
}
const Exact none{RayRelation::none, {}, {}, {}};

}  // namespace

LAW("ray_segment: which end of the segment comes first does not matter", ray, s) {
  return equal(ask(asked), ask(Row::Question{ray, {s.b, s.a}}));
}

LAW("ray_segment: t counts in lengths of the direction", ray, s) {
  const Vector2d longer{2 * ray.direction.x, 2 * ray.direction.y};
  if (!std::isfinite(longer.x) || !std::isfinite(longer.y)) return true;
  const auto answer = ask(asked), found = ask(Row::Question{{ray.origin, longer}, s});
  return answer.relation == found.relation && equal(answer.point, found.point) &&
         equal(answer.overlap, found.overlap) && answer.t.has_value() == found.t.has_value() &&
         (!answer.t || scaled_number(*answer.t, *found.t, -1));
}

ROBUST_LAW("ray_segment: a ray meets what its first length meets, at the same t", ray, s) {
  if (!on_lattice(asked)) return true;
  const auto answer = ask(asked);
  const auto met = robust::segment_segment({ray.origin, ray.origin + ray.direction}, s);
  if (met.relation == SegmentRelation::disjoint) return answer.relation == RayRelation::none || *answer.t >= 1;
  if (met.relation == SegmentRelation::overlap) return answer.relation == RayRelation::overlap && *answer.t < 1;
  return answer.relation != RayRelation::none && equal(met.ta, answer.t);
}

TEST_CASE("ray_segment: p. 14's ray by p. 12's equations worked by hand") {
  // D = V x B, t = (W x B) / D, s = (W x V) / D
  example<Row>({{{0, 0}, {1, 0}}, {{3, -1}, {3, 2}}}, point(3, 3, 0));              // D 3, W (3, -1): 9, s = 1 / 3
  example<Row>({{{0, 0}, {2, 2}}, {{0, 2}, {2, 0}}}, point(Rational(1, 2), 1, 1));  // D -8, W (0, 2): -4, s = -4 / -8
  example<Row>({{{1, 0}, {0, 3}}, {{0, 1}, {2, 1}}}, point(Rational(1, 3), 1, 1));  // D -6, W (-1, 1): -2, s = -3 / -6
  example<Row>({{{0, 0}, {1, 0}}, {{-3, -1}, {-3, 2}}}, none);                      // t = -3: behind
  example<Row>({{{0, 0}, {1, 0}}, {{3, 1}, {3, 2}}}, none);                         // s = -1
  example<Row>({{{0, 0}, {1, 0}}, {{0, 1}, {5, 1}}}, none);                         // D 0
}

TEST_CASE("ray_segment: the origin and both ends are touched in a point") {
  example<Row>({{{1, 0}, {0, 1}}, {{0, 0}, {2, 0}}}, point(0, 1, 0));
  example<Row>({{{0, 0}, {1, 1}}, {{2, 2}, {5, 0}}}, point(2, 2, 2));  // D -5, W (2, 2): -10, s = 0
  example<Row>({{{0, 0}, {1, 1}}, {{5, 0}, {2, 2}}}, point(2, 2, 2));
  example<Row>({{{2, 2}, {-1, 4}}, {{2, 2}, {5, 0}}}, point(0, 2, 2));
}

TEST_CASE("ray_segment: a segment along the ray overlaps it, its ends in order of t") {
  example<Row>({{{0, 0}, {1, 0}}, {{2, 0}, {5, 0}}}, overlap(2, 2, 0, 5, 0), "algorithm");
  example<Row>({{{0, 0}, {1, 0}}, {{5, 0}, {2, 0}}}, overlap(2, 2, 0, 5, 0), "algorithm");
  example<Row>({{{0, 0}, {-2, 0}}, {{-3, 0}, {-8, 0}}}, overlap(Rational(3, 2), -3, 0, -8, 0), "algorithm");
  example<Row>({{{0, 0}, {1, 0}}, {{-2, 0}, {3, 0}}}, overlap(0, 0, 0, 3, 0), "algorithm");
  example<Row>({{{4, 4}, {0, -1}}, {{4, 9}, {4, 1}}}, overlap(0, 4, 4, 4, 1), "algorithm");
  example<Row>({{{0, 0}, {1, 0}}, {{-2, 0}, {0, 0}}}, point(0, 0, 0), "algorithm");  // touched from behind
  example<Row>({{{0, 0}, {1, 0}}, {{-3, 0}, {-1, 0}}}, none);
}

TEST_CASE("ray_segment: a segment of length zero is a point") {
  example<Row>({{{0, 0}, {2, 0}}, {{3, 0}, {3, 0}}}, point(Rational(3, 2), 3, 0), "algorithm");
  example<Row>({{{1, 1}, {2, 0}}, {{1, 1}, {1, 1}}}, point(0, 1, 1), "algorithm");
  example<Row>({{{0, 0}, {2, 0}}, {{-3, 0}, {-3, 0}}}, none);
  example<Row>({{{0, 0}, {2, 0}}, {{3, 1}, {3, 1}}}, none);
}

CONTRACT(
    "ray_segment: the formula in double is right beyond the margin of its contract, its numbers within their bounds",
    ray, segment) {
  const Vector2d along = segment.b - segment.a, w = segment.a - ray.origin;
  const CrossBound d(ray.direction, along, 2);
  const QuotientBound t(CrossBound(w, along, 3), d), s(CrossBound(w, ray.direction, 2), d);
  if (t.certainly_negative() || s.certainly_outside()) {
    return answer.relation == RayRelation::none && truth.answer.relation == RayRelation::none;
  }
  if (!t.certainly_positive() || !s.certainly_inside()) return true;
  if (answer.relation != RayRelation::point || truth.answer.relation != RayRelation::point) return false;
  const auto coordinate_kept = [&](double origin, double step, double computed, const Rational& exactly) {
    const double product = t.computed * step, sum = origin + product;
    if (!finite(product, sum)) return true;
    const Rational bound = size(step) * t.error + unit() * size(product) + unit() * size(sum) + power_of_two(-1075);
    return within(computed, exactly, bound);
  };
  return within(*answer.t, *truth.answer.t, t.error) &&
         coordinate_kept(ray.origin.x, ray.direction.x, answer.point->x, truth.answer.point->x) &&
         coordinate_kept(ray.origin.y, ray.direction.y, answer.point->y, truth.answer.point->y);
}

}  // namespace touchstone::proptests::ray_segment_tests
