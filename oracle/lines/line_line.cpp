// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/line_line.h"

#include "geometry/door.h"
#include "oracle/exact/common_power.h"

namespace touchstone::oracle {
namespace {

/// Homogeneous: a point (x : y : w), or the line of all (x : y : w) with product sum 0.
struct Homogeneous {
  Integer x, y, w;
};

Homogeneous cross_product(const Homogeneous& g, const Homogeneous& h) {
  return {Integer(g.y * h.w - g.w * h.y), Integer(g.w * h.x - g.x * h.w), Integer(g.x * h.y - g.y * h.x)};
}

struct Lines {
  Point2<Integer> a_start, b_start;
  Vector2<Integer> a_direction, b_direction;
  Homogeneous meet;
  int exponent;
};

Lines intersect(const Line2d& a, const Line2d& b) {
  door::admit("a", a), door::admit("b", b);
  const CommonPower<8> n({a.p.x, a.p.y, a.q.x, a.q.y, b.p.x, b.p.y, b.q.x, b.q.y});
  const auto homogeneous = [](const Point2<Integer>& p) { return Homogeneous{p.x, p.y, Integer(1)}; };
  const Point2<Integer> ap{n.whole(0), n.whole(1)}, aq{n.whole(2), n.whole(3)};
  const Point2<Integer> bp{n.whole(4), n.whole(5)}, bq{n.whole(6), n.whole(7)};
  const Homogeneous line_a = cross_product(homogeneous(ap), homogeneous(aq));
  const Homogeneous line_b = cross_product(homogeneous(bp), homogeneous(bq));
  return {ap, bp, aq - ap, bq - bp, cross_product(line_a, line_b), n.exponent()};
}

/// Where along a line its point (x/w, y/w) lies: the projection (point - start).direction / direction.direction.
Rational parameter(const Homogeneous& point, const Point2<Integer>& start, const Vector2<Integer>& direction) {
  const Vector2<Integer> from{Integer(point.x - start.x * point.w), Integer(point.y - start.y * point.w)};
  return quotient(dot(from, direction), Integer(point.w * dot(direction, direction)));
}

Rational parameter(const Point2<Integer>& point, const Point2<Integer>& start, const Vector2<Integer>& direction) {
  return parameter(Homogeneous{point.x, point.y, Integer(1)}, start, direction);
}

}  // namespace

Truth<LineLine<Rational>> line_line(const Line2d& a, const Line2d& b) {
  const Lines s = intersect(a, b);
  if (sgn(s.meet.w) == 0) {
    const bool same = sgn(s.meet.x) == 0 && sgn(s.meet.y) == 0;
    return {{same ? LineRelation::same : LineRelation::parallel, {}, {}, {}}, Rational(0)};
  }
  const Point2<Rational> point{scaled(quotient(s.meet.x, s.meet.w), s.exponent),
                               scaled(quotient(s.meet.y, s.meet.w), s.exponent)};
  return {{LineRelation::crossing, parameter(s.meet, s.a_start, s.a_direction),
           parameter(s.meet, s.b_start, s.b_direction), point},
          scaled(Integer(abs(s.meet.w)), 2 * s.exponent)};
}

Certificate line_line_certificate(const Line2d& a, const Line2d& b) {
  const Lines s = intersect(a, b);
  if (sgn(s.meet.w) != 0) {
    return {"transversal", {{"determinant", {scaled(cross(s.a_direction, s.b_direction), 2 * s.exponent)}}}};
  }
  if (sgn(s.meet.x) != 0 || sgn(s.meet.y) != 0) {
    const Vector2<Integer>& d = s.a_direction;
    return {"level_lines", {{"normal", {Rational(-d.y), Rational(d.x)}}}};
  }
  const Point2<Integer> b_end = s.b_start + s.b_direction;
  return {"same_line",
          {{"on_a", {parameter(s.b_start, s.a_start, s.a_direction), parameter(b_end, s.a_start, s.a_direction)}}}};
}

}  // namespace touchstone::oracle
