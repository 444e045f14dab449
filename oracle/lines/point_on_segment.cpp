// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/point_on_segment.h"

#include "geometry/validation.h"
#include "oracle/exact/numbers/common_scale.h"
#include "oracle/exact/systems/common_points.h"

namespace touchstone::oracle {
namespace {

template <class Number>
using PointOnSegmentScale = CommonScale<Number, 6>;

template <class Number>
PointOnSegmentScale<Number> validated_point_on_segment(const Point2<Number>& point, const Segment2<Number>& segment) {
  const PointOnSegmentScale<Number> n({point.x, point.y, segment.a.x, segment.a.y, segment.b.x, segment.b.y});
  if (!n.finite())
    validation::validate("point", point), validation::validate("segment", segment);  // names the field: slower
  return n;
}

template <class Value>
struct Situation {
  Point2<Value> point;
  Segment2<Value> segment;
  Value along, length;  // w.v and v.v
  bool on;
};

template <class Value, class Number>
Situation<Value> examine(const PointOnSegmentScale<Number>& n) {
  Situation<Value> s{integer_point<Value>(n, 0), integer_segment<Value>(n, 2), {}, {}, {}};
  const Vector2<Value> v = s.segment.b - s.segment.a, w = s.point - s.segment.a;
  const Value distance = dot(w, w);
  s.along = dot(w, v), s.length = dot(v, v);
  const bool collinear = product(s.along, s.along) == product(distance, s.length);
  const bool between = sgn(s.along) >= 0 && s.along <= s.length;
  s.on = sgn(s.length) == 0 ? sgn(distance) == 0 : collinear && between;
  return s;
}

template <class Value>
Rational parameter_point_on_segment(const Situation<Value>& s) {
  return sgn(s.length) == 0 ? Rational(0) : quotient(s.along, s.length);
}

template <class Value, class Number>
Certificate certificate_point_on_segment(const PointOnSegmentScale<Number>& n, const Situation<Value>& s) {
  if (s.on) {
    const Rational t = parameter_point_on_segment(s);
    return {"weights", {{"weights", {Rational(1 - t), t}}}};
  }
  // From the point to the nearest point of the segment; every point of the segment is at least as far along.
  const Rational t = std::clamp(parameter_point_on_segment(s), Rational(0), Rational(1));
  const Point2<Rational> nearest = actual_point(n, point_at(s.segment, t)),
                         from = actual_point(n, {rational(s.point.x), rational(s.point.y)});
  const Vector2<Rational> normal = nearest - from;
  const Rational offset((normal.x * (nearest.x + from.x) + normal.y * (nearest.y + from.y)) / 2);
  return {"separating_line", {{"normal", {normal.x, normal.y}}, {"offset", {offset}}}};
}

template <class Value, class Number>
Truth<PointOnSegment<Rational>> solved_point_on_segment(const PointOnSegmentScale<Number>& n,
                                                        const Situation<Value>& s) {
  if (s.on) return {{Incidence::on, parameter_point_on_segment(s)}, Rational(0)};
  const SquaredLength<Value> distance = squared_distance(s.point, s.segment, Extent::segment);
  return {{Incidence::off, {}}, n.actual(quotient(distance.numerator, distance.denominator), 2)};
}

template <class Value, class Number>
Truth<PointOnSegment<Rational>> truth_point_on_segment(const PointOnSegmentScale<Number>& n) {
  Situation<Value> s = examine<Value>(n);
  Truth<PointOnSegment<Rational>> found = solved_point_on_segment(n, s);
  found.certificate = [n, s = std::move(s)] { return certificate_point_on_segment(n, s); };
  return found;
}

}  // namespace

template <Exact Number>
Truth<PointOnSegment<Rational>> point_on_segment(const Point2<Number>& point, const Segment2<Number>& segment) {
  const PointOnSegmentScale<Number> n = validated_point_on_segment(point, segment);
  return n.bits() <= most_bits_in_words ? truth_point_on_segment<Int128>(n) : truth_point_on_segment<Integer>(n);
}
template Truth<PointOnSegment<Rational>> point_on_segment(const Point2d&, const Segment2d&);
template Truth<PointOnSegment<Rational>> point_on_segment(const Point2<Rational>&, const Segment2<Rational>&);

}  // namespace touchstone::oracle
