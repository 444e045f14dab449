// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/line_line.h"

#include "oracle/exact/common_scale.h"
#include "oracle/exact/rational_door.h"

namespace touchstone::oracle {
namespace {

/// Homogeneous: a point (x : y : w), or the line of all (x : y : w) with product sum 0.
struct Homogeneous {
  Integer x, y, w;
};

Homogeneous cross_product(const Homogeneous& g, const Homogeneous& h) {
  return {Integer(g.y * h.w - g.w * h.y), Integer(g.w * h.x - g.x * h.w), Integer(g.x * h.y - g.y * h.x)};
}

template <class Number>
struct Lines {
  CommonScale<Number, 8> scale;
  Point2<Integer> a_start, b_start;
  Vector2<Integer> a_direction, b_direction;
  Homogeneous meet;
};

template <class Number>
Lines<Number> intersect(const Line2<Number>& a, const Line2<Number>& b) {
  const CommonScale<Number, 8> n({a.p.x, a.p.y, a.q.x, a.q.y, b.p.x, b.p.y, b.q.x, b.q.y});
  const auto homogeneous = [](const Point2<Integer>& p) { return Homogeneous{p.x, p.y, Integer(1)}; };
  const Point2<Integer> ap = whole_point(n, 0), aq = whole_point(n, 2), bp = whole_point(n, 4), bq = whole_point(n, 6);
  if (!n.finite() || ap == aq || bp == bq) door::admit("a", a), door::admit("b", b);  // names the field: slower
  const Homogeneous line_a = cross_product(homogeneous(ap), homogeneous(aq));
  const Homogeneous line_b = cross_product(homogeneous(bp), homogeneous(bq));
  return {n, ap, bp, aq - ap, bq - bp, cross_product(line_a, line_b)};
}

/// t of start + t direction = (x/w, y/w), by the first coordinate that moves.
Rational parameter(const Homogeneous& point, const Point2<Integer>& start, const Vector2<Integer>& direction) {
  return sgn(direction.x) != 0 ? quotient(Integer(point.x - start.x * point.w), Integer(direction.x * point.w))
                               : quotient(Integer(point.y - start.y * point.w), Integer(direction.y * point.w));
}

template <class Number>
Truth<LineLine<Rational>> truth(const Lines<Number>& s) {
  if (sgn(s.meet.w) == 0) {
    const bool same = sgn(s.meet.x) == 0 && sgn(s.meet.y) == 0;
    return {{same ? LineRelation::same : LineRelation::parallel, {}, {}, {}}, Rational(0)};
  }
  const Point2<Rational> point{quotient(s.meet.x, s.meet.w), quotient(s.meet.y, s.meet.w)};
  return {{LineRelation::crossing, parameter(s.meet, s.a_start, s.a_direction),
           parameter(s.meet, s.b_start, s.b_direction), actual_point(s.scale, point)},
          s.scale.actual(Integer(abs(s.meet.w)), 2)};
}

}  // namespace

Truth<LineLine<Rational>> line_line(const Line2d& a, const Line2d& b) { return truth(intersect(a, b)); }

template <Exact Number>
Truth<LineLine<Rational>> line_line(const Line2<Number>& a, const Line2<Number>& b) {
  return truth(intersect(a, b));
}
template Truth<LineLine<Rational>> line_line(const Line2<Rational>&, const Line2<Rational>&);

Certificate line_line_certificate(const Line2d& a, const Line2d& b) {
  const Lines<double> s = intersect(a, b);
  if (sgn(s.meet.w) != 0) {
    return {"transversal", {{"determinant", {s.scale.actual(cross(s.a_direction, s.b_direction), 2)}}}};
  }
  if (sgn(s.meet.x) != 0 || sgn(s.meet.y) != 0) {
    const Vector2<Integer>& d = s.a_direction;
    return {"level_lines", {{"normal", {Rational(-d.y), Rational(d.x)}}}};
  }
  const auto on_a = [&s](const Point2<Integer>& p) {
    return parameter({p.x, p.y, Integer(1)}, s.a_start, s.a_direction);
  };
  return {"same_line", {{"on_a", {on_a(s.b_start), on_a(s.b_start + s.b_direction)}}}};
}

}  // namespace touchstone::oracle
