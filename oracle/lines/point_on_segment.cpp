// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/point_on_segment.h"

#include "geometry/door.h"
#include "oracle/exact/common_points.h"
#include "oracle/exact/common_power.h"

namespace touchstone::oracle {
namespace {

struct Situation {
  Point2<Integer> point;
  Segment2<Integer> segment;
  int exponent;
  Integer along, length;  // w.v and v.v
  bool on;
};

Situation examine(const Point2d& point, const Segment2d& segment) {
  door::admit("point", point), door::admit("segment", segment);
  const CommonPower<6> n({point.x, point.y, segment.a.x, segment.a.y, segment.b.x, segment.b.y});
  Situation s{{n.whole(0), n.whole(1)}, {{n.whole(2), n.whole(3)}, {n.whole(4), n.whole(5)}}, n.exponent(), {}, {}, {}};
  const Vector2<Integer> v = s.segment.b - s.segment.a, w = s.point - s.segment.a;
  const Integer distance = dot(w, w);
  s.along = dot(w, v), s.length = dot(v, v);
  const bool collinear = Integer(s.along * s.along) == Integer(distance * s.length);
  const bool between = sgn(s.along) >= 0 && s.along <= s.length;
  s.on = sgn(s.length) == 0 ? sgn(distance) == 0 : collinear && between;
  return s;
}

Rational parameter(const Situation& s) { return sgn(s.length) == 0 ? Rational(0) : quotient(s.along, s.length); }

}  // namespace

Truth<PointOnSegment<Rational>> point_on_segment(const Point2d& point, const Segment2d& segment) {
  const Situation s = examine(point, segment);
  if (s.on) return {{Incidence::on, parameter(s)}, Rational(0)};
  const SquaredLength distance = squared_distance(s.point, s.segment, Extent::segment);
  return {{Incidence::off, {}}, scaled(quotient(distance.numerator, distance.denominator), 2 * s.exponent)};
}

Certificate point_on_segment_certificate(const Point2d& point, const Segment2d& segment) {
  const Situation s = examine(point, segment);
  if (s.on) {
    const Rational t = parameter(s);
    return {"weights", {{"weights", {Rational(1 - t), t}}}};
  }
  // From the point to the nearest point of the segment; every point of the segment is at least as far along.
  Rational t = parameter(s);
  if (t < 0) t = 0;
  if (t > 1) t = 1;
  const Point2<Rational> nearest = point_at(s.segment, t, s.exponent), from{exact(point.x), exact(point.y)};
  const Vector2<Rational> normal = nearest - from;
  const Rational offset((normal.x * (nearest.x + from.x) + normal.y * (nearest.y + from.y)) / 2);
  return {"separating_line", {{"normal", {normal.x, normal.y}}, {"offset", {offset}}}};
}

}  // namespace touchstone::oracle
