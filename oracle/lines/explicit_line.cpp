// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/explicit_line.h"

#include "geometry/door.h"
#include "oracle/exact/decode.h"

namespace touchstone::oracle {
namespace {

Rational height(double slope, double intercept, const Point2d& point) {
  door::admit("slope", slope), door::admit("intercept", intercept), door::admit("point", point);
  return Rational(exact(point.y) - (exact(slope) * exact(point.x) + exact(intercept)));
}

}  // namespace

Truth<Height> explicit_line(double slope, double intercept, const Point2d& point) {
  const Rational e = height(slope, intercept, point);
  return {sgn(e) > 0 ? Height::above : sgn(e) < 0 ? Height::below : Height::on, Rational(abs(e))};
}

Certificate explicit_line_certificate(double slope, double intercept, const Point2d& point) {
  return {"height", {{"height", {height(slope, intercept, point)}}}};
}

}  // namespace touchstone::oracle
