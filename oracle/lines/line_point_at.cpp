// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/line_point_at.h"

#include <algorithm>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/common_scale.h"
#include "oracle/exact/numbers/nearest_double.h"

namespace touchstone::oracle {
namespace {

/// t times the direction, in units of `lengths`.
template <class Number>
struct Travelled {
  Travelled(const ParametricLine2<Number>& line, const Number& t)
      : lengths({line.origin.x, line.origin.y, line.direction.x, line.direction.y}) {
    const CommonScale<Number, 1> time({t});
    const bool still = validation::zero(line.direction.x) && validation::zero(line.direction.y);
    if (!lengths.finite() || !time.finite() || still) validation::validate_all("line", line, "t", t);
    const Integer factor = time.integer(0);
    const auto step = [&](std::size_t i) { return time.actual(rational(Integer(factor * lengths.integer(i))), 1); };
    x = step(2), y = step(3);
  }

  CommonScale<Number, 4> lengths;
  Rational x, y;
};

template <class Number>
Truth<Point2<Rational>> truth_line_point_at(Travelled<Number> s) {
  std::function<Certificate()> certificate = [s] {
    return Certificate{"displacement", {{"displacement", {s.lengths.actual(s.x, 1), s.lengths.actual(s.y, 1)}}}};
  };
  const auto add = [](const Integer& whole, Rational& step) {  // no common factor comes in
    mpz_addmul(step.get_num_mpz_t(), whole.get_mpz_t(), step.get_den_mpz_t());
  };
  add(s.lengths.integer(0), s.x), add(s.lengths.integer(1), s.y);
  Point2<Rational> point = actual_point(s.lengths, {std::move(s.x), std::move(s.y)});
  Rational margin = std::min(rounding_margin(point.x), rounding_margin(point.y));
  return {std::move(point), std::move(margin), std::move(certificate)};
}

}  // namespace

template <Exact Number>
Truth<Point2<Rational>> line_point_at(const ParametricLine2<Number>& line, const Number& t) {
  return truth_line_point_at(Travelled<Number>(line, t));
}
template Truth<Point2<Rational>> line_point_at(const ParametricLine2d&, const double&);
template Truth<Point2<Rational>> line_point_at(const ParametricLine2<Rational>&, const Rational&);

}  // namespace touchstone::oracle
