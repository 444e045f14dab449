// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/ray_segment.h"

#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/common_scale.h"
#include "oracle/exact/systems/common_points.h"

namespace touchstone::oracle {
namespace {

template <class Number>
CommonScale<Number, 8> validated_ray_segment(const Ray2<Number>& ray, const Segment2<Number>& segment) {
  const CommonScale<Number, 8> n({ray.origin.x, ray.origin.y, ray.direction.x, ray.direction.y, segment.a.x,
                                  segment.a.y, segment.b.x, segment.b.y});
  const bool still = validation::zero(ray.direction.x) && validation::zero(ray.direction.y);
  if (!n.finite() || still) validation::validate_all("ray", ray, "segment", segment);  // names the field: slower
  return n;
}

template <class Value>
struct RaySegmentSolved {
  template <class Number>
  explicit RaySegmentSolved(const CommonScale<Number, 8>& n)
      : ray(from_origin(integer_segment<Value>(n, 0))),
        segment(integer_segment<Value>(n, 4)),
        common(ray, Extent::ray, segment) {}

  static Segment2<Value> from_origin(const Segment2<Value>& origin_and_direction) {
    const Point2<Value>&o = origin_and_direction.a, &d = origin_and_direction.b;
    return {o, {Value(o.x + d.x), Value(o.y + d.y)}};
  }

  Segment2<Value> ray;  // a: origin, b: origin + direction
  Segment2<Value> segment;
  CommonPoints<Value> common;
};

template <class Value, class Number>
Certificate certificate_ray_segment(const CommonScale<Number, 8>& n, const RaySegmentSolved<Value>& s) {
  const CommonPoints<Value>& common = s.common;
  const auto line = [&](const Vector2<Value>& normal) -> decltype(Certificate::facts) {
    return {{"normal", {rational(normal.x), rational(normal.y)}},
            {"offset", {n.actual(halfway(normal, s.ray, Extent::ray, s.segment), 1)}}};
  };
  if (!common.any) return {"separating_line", line(common.normal)};
  if (common.extended) {
    return {"overlap",
            {{"on_ray", {rational(common.first), rational(common.last)}},
             {"on_segment", {rational(common.second_at_first), rational(common.second_at_last)}}}};
  }
  if (s.segment.a == s.segment.b) return {"single_point", {}};
  const std::pair<std::string, std::vector<Rational>> witness{"on_segment", {rational(common.second_at_first)}};
  const Vector2<Value> direction = s.ray.b - s.ray.a;
  const Value area = cross(direction, s.segment.b - s.segment.a);
  if (sgn(area) != 0) return {"transversal", {witness, {"determinant", {n.actual(rational(area), 2)}}}};
  // Collinear and end to end: the ray starts where the segment does, and leaves it.
  Certificate supporting{"supporting_line", line({Value(-direction.x), Value(-direction.y)})};
  supporting.facts.insert(supporting.facts.begin(), witness);
  return supporting;
}

template <class Value, class Number>
Truth<RaySegment<Rational>> solved_ray_segment(const CommonScale<Number, 8>& n, const RaySegmentSolved<Value>& s) {
  const CommonPoints<Value>& common = s.common;
  const auto end_distance = [&] { return n.actual(least_end_distance(s.ray, Extent::ray, s.segment), 2); };
  if (!common.any) return {{RayRelation::none, {}, {}, {}}, end_distance()};
  Rational t = rational(common.first);
  Point2<Rational> first = actual_point(n, point_at(s.ray, t));
  if (common.extended) {
    Point2<Rational> last = actual_point(n, point_at(s.ray, rational(common.last)));
    return {{RayRelation::overlap, std::move(t), {}, Segment2<Rational>{std::move(first), std::move(last)}},
            Rational(0)};
  }
  const Fraction<Value>& on_segment = common.second_at_first;
  const bool touching = sgn(t) == 0 || sgn(on_segment.numerator) == 0 || on_segment.numerator == on_segment.denominator;
  return {{RayRelation::point, std::move(t), std::move(first), {}}, touching ? Rational(0) : end_distance()};
}

template <class Value, class Number>
Truth<RaySegment<Rational>> truth_ray_segment(const CommonScale<Number, 8>& n) {
  RaySegmentSolved<Value> s(n);
  Truth<RaySegment<Rational>> found = solved_ray_segment(n, s);
  found.certificate = [n, s = std::move(s)] { return certificate_ray_segment(n, s); };
  return found;
}

}  // namespace

template <Exact Number>
Truth<RaySegment<Rational>> ray_segment(const Ray2<Number>& ray, const Segment2<Number>& segment) {
  const CommonScale<Number, 8> n = validated_ray_segment(ray, segment);
  return n.bits() < most_bits_in_words ? truth_ray_segment<Int128>(n)
                                       : truth_ray_segment<Integer>(n);  // origin + direction: one bit more
}
template Truth<RaySegment<Rational>> ray_segment(const Ray2d&, const Segment2d&);
template Truth<RaySegment<Rational>> ray_segment(const Ray2<Rational>&, const Segment2<Rational>&);

}  // namespace touchstone::oracle
