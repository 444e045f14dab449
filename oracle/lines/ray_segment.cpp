// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/ray_segment.h"

#include "geometry/door.h"
#include "oracle/exact/common_points.h"
#include "oracle/exact/common_power.h"

namespace touchstone::oracle {
namespace {

struct Solved {
  Segment2<Integer> ray;  // a: origin, b: origin + direction
  Segment2<Integer> segment;
  int exponent;
  CommonPoints common;
};

Solved solve(const Ray2d& ray, const Segment2d& segment) {
  door::admit("ray", ray), door::admit("segment", segment);
  const CommonPower<8> n({ray.origin.x, ray.origin.y, ray.direction.x, ray.direction.y, segment.a.x, segment.a.y,
                          segment.b.x, segment.b.y});
  const Point2<Integer> origin{n.whole(0), n.whole(1)};
  const Segment2<Integer> whole_ray{origin, {Integer(origin.x + n.whole(2)), Integer(origin.y + n.whole(3))}};
  const Segment2<Integer> whole_segment{{n.whole(4), n.whole(5)}, {n.whole(6), n.whole(7)}};
  return {whole_ray, whole_segment, n.exponent(), common_points(whole_ray, Extent::ray, whole_segment, n.bits() + 1)};
}

}  // namespace

Truth<RaySegment<Rational>> ray_segment(const Ray2d& ray, const Segment2d& segment) {
  const Solved s = solve(ray, segment);
  if (!s.common.any)
    return {{RayRelation::none, {}, {}, {}}, least_end_distance(s.ray, Extent::ray, s.segment, s.exponent)};
  const Rational &t = s.common.first, &on_segment = s.common.second_at_first;
  const Point2<Rational> first = point_at(s.ray, t, s.exponent);
  if (t < s.common.last) {
    const Point2<Rational> last = point_at(s.ray, s.common.last, s.exponent);
    return {{RayRelation::overlap, t, {}, Segment2<Rational>{first, last}}, Rational(0)};
  }
  const bool touching = t == 0 || on_segment == 0 || on_segment == 1;
  return {{RayRelation::point, t, first, {}},
          touching ? Rational(0) : least_end_distance(s.ray, Extent::ray, s.segment, s.exponent)};
}

Certificate ray_segment_certificate(const Ray2d& ray, const Segment2d& segment) {
  const Solved s = solve(ray, segment);
  const CommonPoints& common = s.common;
  if (!common.any) {
    const Rational offset = halfway(common.normal, s.ray, Extent::ray, s.segment, s.exponent);
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
  if (sgn(area) != 0) return {"transversal", {witness, {"determinant", {scaled(area, 2 * s.exponent)}}}};
  // Collinear and end to end: the ray starts where the segment does, and leaves it.
  const Vector2<Integer> back{Integer(-direction.x), Integer(-direction.y)};
  const Rational offset = halfway(back, s.ray, Extent::ray, s.segment, s.exponent);
  return {"supporting_line", {witness, {"normal", {Rational(back.x), Rational(back.y)}}, {"offset", {offset}}}};
}

}  // namespace touchstone::oracle
