// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/implicit_circle.h"

#include "oracle/exact/common_scale.h"
#include "oracle/exact/rational_door.h"

namespace touchstone::oracle {
namespace {

struct Squares {
  Rational distance, radius;
};

template <class Number>
Squares squares(const Circle2<Number>& circle, const Point2<Number>& point) {
  door::admit("circle", circle), door::admit("point", point);
  const CommonScale<Number, 5> n({circle.center.x, circle.center.y, circle.radius, point.x, point.y});
  const Vector2<Integer> from_center = whole_point(n, 3) - whole_point(n, 0);
  const Integer radius = n.whole(2);
  return {n.actual(dot(from_center, from_center), 2), n.actual(Integer(radius * radius), 2)};
}

Truth<Location> truth(const Squares& s) {
  const Rational e(s.distance - s.radius);
  return {sgn(e) < 0 ? Location::inside : sgn(e) > 0 ? Location::outside : Location::boundary, Rational(abs(e))};
}

}  // namespace

Truth<Location> implicit_circle(const Circle2d& circle, const Point2d& point) { return truth(squares(circle, point)); }

template <Exact Number>
Truth<Location> implicit_circle(const Circle2<Number>& circle, const Point2<Number>& point) {
  return truth(squares(circle, point));
}
template Truth<Location> implicit_circle(const Circle2<Rational>&, const Point2<Rational>&);

Certificate implicit_circle_certificate(const Circle2d& circle, const Point2d& point) {
  const Squares s = squares(circle, point);
  return {"squares", {{"squared_distance", {s.distance}}, {"squared_radius", {s.radius}}}};
}

}  // namespace touchstone::oracle
