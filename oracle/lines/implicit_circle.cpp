// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/implicit_circle.h"

#include "geometry/validation.h"
#include "oracle/exact/numbers/common_scale.h"

namespace touchstone::oracle {
namespace {

template <class Number>
using ImplicitCircleScale = CommonScale<Number, 5>;

template <class Number>
ImplicitCircleScale<Number> validated_implicit_circle(const Circle2<Number>& circle, const Point2<Number>& point) {
  const ImplicitCircleScale<Number> n({circle.center.x, circle.center.y, circle.radius, point.x, point.y});
  if (!n.finite() || validation::negative(circle.radius)) validation::validate_all("circle", circle, "point", point);
  return n;
}

template <class Value, class Number>
Truth<Location> truth_implicit_circle(const ImplicitCircleScale<Number>& n) {
  const Vector2<Value> from_center = integer_point<Value>(n, 3) - integer_point<Value>(n, 0);
  const Value radius = integer<Value>(n, 2), distance = dot(from_center, from_center), square(radius * radius);
  const Value e(distance - square);
  return {sgn(e) < 0   ? Location::inside
          : sgn(e) > 0 ? Location::outside
                       : Location::boundary,
          n.actual(absolute(e), 2), [n, distance, square] {
            return Certificate{"squares",
                               {{"squared_distance", {n.actual(rational(distance), 2)}},
                                {"squared_radius", {n.actual(rational(square), 2)}}}};
          }};
}

}  // namespace

template <Exact Number>
Truth<Location> implicit_circle(const Circle2<Number>& circle, const Point2<Number>& point) {
  const ImplicitCircleScale<Number> n = validated_implicit_circle(circle, point);
  return n.bits() <= most_bits_in_words ? truth_implicit_circle<Int128>(n) : truth_implicit_circle<Integer>(n);
}
template Truth<Location> implicit_circle(const Circle2d&, const Point2d&);
template Truth<Location> implicit_circle(const Circle2<Rational>&, const Point2<Rational>&);

}  // namespace touchstone::oracle
