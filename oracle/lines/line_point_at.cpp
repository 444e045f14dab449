// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/line_point_at.h"

#include <algorithm>

#include "oracle/exact/common_scale.h"
#include "oracle/exact/nearest_double.h"
#include "oracle/exact/rational_door.h"

namespace touchstone::oracle {
namespace {

template <class Number>
struct Travelled {
  CommonScale<Number, 4> lengths;
  Vector2<Rational> step;  // in units of length
};

template <class Number>
Travelled<Number> travel(const ParametricLine2<Number>& line, const Number& t) {
  const CommonScale<Number, 4> lengths({line.origin.x, line.origin.y, line.direction.x, line.direction.y});
  const CommonScale<Number, 1> time({t});
  const Integer x = lengths.whole(2), y = lengths.whole(3);
  const bool still = sgn(x) == 0 && sgn(y) == 0;
  if (!lengths.finite() || !time.finite() || still) door::admit("line", line), door::admit("t", t);
  const Integer factor = time.whole(0);
  return {lengths, {time.actual(Integer(factor * x), 1), time.actual(Integer(factor * y), 1)}};
}

template <class Number>
Truth<Point2<Rational>> truth(const Travelled<Number>& s) {
  const auto sum = [](const Integer& whole, Rational step) {
    step.get_num() += whole * step.get_den();  // no common factor comes in
    return step;
  };
  const Point2<Rational> point =
      actual_point(s.lengths, {sum(s.lengths.whole(0), s.step.x), sum(s.lengths.whole(1), s.step.y)});
  return {point, std::min(rounding_margin(point.x), rounding_margin(point.y))};
}

}  // namespace

Truth<Point2<Rational>> line_point_at(const ParametricLine2d& line, double t) { return truth(travel(line, t)); }

template <Exact Number>
Truth<Point2<Rational>> line_point_at(const ParametricLine2<Number>& line, const Number& t) {
  return truth(travel(line, t));
}
template Truth<Point2<Rational>> line_point_at(const ParametricLine2<Rational>&, const Rational&);

Certificate line_point_at_certificate(const ParametricLine2d& line, double t) {
  const Travelled<double> s = travel(line, t);
  return {"displacement", {{"displacement", {s.lengths.actual(s.step.x, 1), s.lengths.actual(s.step.y, 1)}}}};
}

}  // namespace touchstone::oracle
