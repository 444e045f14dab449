// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/ray_segment.h"

#include "oracle/exact/common_points.h"
#include "oracle/exact/common_scale.h"
#include "oracle/exact/rational_door.h"

namespace touchstone::oracle {
namespace {

template <class Number>
struct Solved {
  CommonScale<Number, 8> scale;
  Segment2<Integer> ray;  // a: origin, b: origin + direction
  Segment2<Integer> segment;
  CommonPoints common;
};

template <class Number>
Solved<Number> solve(const Ray2<Number>& ray, const Segment2<Number>& segment) {
  const CommonScale<Number, 8> n({ray.origin.x, ray.origin.y, ray.direction.x, ray.direction.y, segment.a.x,
                                  segment.a.y, segment.b.x, segment.b.y});
  const Point2<Integer> origin = whole_point(n, 0);
  const Vector2<Integer> direction{n.whole(2), n.whole(3)};
  const bool still = sgn(direction.x) == 0 && sgn(direction.y) == 0;
  if (!n.finite() || still) door::admit("ray", ray), door::admit("segment", segment);  // names the field: slower
  const Segment2<Integer> whole_ray{origin, origin + direction}, whole = whole_segment(n, 4);
  return {n, whole_ray, whole, common_points(whole_ray, Extent::ray, whole, n.bits() + 1)};
}

template <class Number>
Truth<RaySegment<Rational>> truth(const Solved<Number>& s) {
  const auto end_distance = [&s] { return s.scale.actual(least_end_distance(s.ray, Extent::ray, s.segment), 2); };
  if (!s.common.any) return {{RayRelation::none, {}, {}, {}}, end_distance()};
  const Rational &t = s.common.first, &on_segment = s.common.second_at_first;
  const Point2<Rational> first = actual_point(s.scale, point_at(s.ray, t));
  if (t < s.common.last) {
    const Point2<Rational> last = actual_point(s.scale, point_at(s.ray, s.common.last));
    return {{RayRelation::overlap, t, {}, Segment2<Rational>{first, last}}, Rational(0)};
  }
  const bool touching = t == 0 || on_segment == 0 || on_segment == 1;
  return {{RayRelation::point, t, first, {}}, touching ? Rational(0) : end_distance()};
}

}  // namespace

Truth<RaySegment<Rational>> ray_segment(const Ray2d& ray, const Segment2d& segment) {
  return truth(solve(ray, segment));
}

template <Exact Number>
Truth<RaySegment<Rational>> ray_segment(const Ray2<Number>& ray, const Segment2<Number>& segment) {
  return truth(solve(ray, segment));
}
template Truth<RaySegment<Rational>> ray_segment(const Ray2<Rational>&, const Segment2<Rational>&);

Certificate ray_segment_certificate(const Ray2d& ray, const Segment2d& segment) {
  const Solved<double> s = solve(ray, segment);
  const CommonPoints& common = s.common;
  if (!common.any) {
    const Rational offset = s.scale.actual(halfway(common.normal, s.ray, Extent::ray, s.segment), 1);
    return {"separating_line",
            {{"normal", {Rational(common.normal.x), Rational(common.normal.y)}}, {"offset", {offset}}}};
  }
  if (common.first < common.last) {
    return {"overlap",
            {{"on_ray", {common.first, common.last}}, {"on_segment", {common.second_at_first, common.second_at_last}}}};
  }
  const std::pair<std::string, std::vector<Rational>> witness{"on_segment", {common.second_at_first}};
  if (s.segment.a == s.segment.b) return {"single_point", {}};
  const Vector2<Integer> direction = s.ray.b - s.ray.a, v = s.segment.b - s.segment.a;
  const Integer area = cross(direction, v);
  if (sgn(area) != 0) return {"transversal", {witness, {"determinant", {s.scale.actual(area, 2)}}}};
  // Collinear and end to end: the ray starts where the segment does, and leaves it.
  const Vector2<Integer> back{Integer(-direction.x), Integer(-direction.y)};
  const Rational offset = s.scale.actual(halfway(back, s.ray, Extent::ray, s.segment), 1);
  return {"supporting_line", {witness, {"normal", {Rational(back.x), Rational(back.y)}}, {"offset", {offset}}}};
}

}  // namespace touchstone::oracle
