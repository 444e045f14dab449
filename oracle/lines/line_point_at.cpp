// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/line_point_at.h"

#include <algorithm>

#include "geometry/door.h"
#include "oracle/exact/decode.h"
#include "oracle/exact/nearest_double.h"

namespace touchstone::oracle {
namespace {

Vector2<Rational> displacement(const ParametricLine2d& line, double t) {
  door::admit("line", line), door::admit("t", t);
  const Rational factor = exact(t);
  return {Rational(factor * exact(line.direction.x)), Rational(factor * exact(line.direction.y))};
}

}  // namespace

Truth<Point2<Rational>> line_point_at(const ParametricLine2d& line, double t) {
  const Vector2<Rational> step = displacement(line, t);
  const Point2<Rational> point{Rational(exact(line.origin.x) + step.x), Rational(exact(line.origin.y) + step.y)};
  return {point, std::min(rounding_margin(point.x), rounding_margin(point.y))};
}

Certificate line_point_at_certificate(const ParametricLine2d& line, double t) {
  const Vector2<Rational> step = displacement(line, t);
  return {"displacement", {{"displacement", {step.x, step.y}}}};
}

}  // namespace touchstone::oracle
