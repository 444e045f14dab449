// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/implicit_circle.h"

#include "geometry/door.h"
#include "oracle/exact/common_power.h"

namespace touchstone::oracle {
namespace {

struct Squares {
  Rational distance, radius;
};

Squares squares(const Circle2d& circle, const Point2d& point) {
  door::admit("circle", circle), door::admit("point", point);
  const CommonPower<5> numbers({circle.center.x, circle.center.y, circle.radius, point.x, point.y});
  const Integer x(numbers.whole(3) - numbers.whole(0)), y(numbers.whole(4) - numbers.whole(1));
  const Integer radius = numbers.whole(2);
  const int square = 2 * numbers.exponent();
  return {scaled(Integer(x * x + y * y), square), scaled(Integer(radius * radius), square)};
}

}  // namespace

Truth<Location> implicit_circle(const Circle2d& circle, const Point2d& point) {
  const Squares s = squares(circle, point);
  const Rational e(s.distance - s.radius);
  return {sgn(e) < 0 ? Location::inside : sgn(e) > 0 ? Location::outside : Location::boundary, Rational(abs(e))};
}

Certificate implicit_circle_certificate(const Circle2d& circle, const Point2d& point) {
  const Squares s = squares(circle, point);
  return {"squares", {{"squared_distance", {s.distance}}, {"squared_radius", {s.radius}}}};
}

}  // namespace touchstone::oracle
