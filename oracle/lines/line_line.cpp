// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/line_line.h"

#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/common_scale.h"
#include "oracle/exact/systems/common_points.h"

namespace touchstone::oracle {
namespace {

template <class Number>
using LineLineScale = CommonScale<Number, 8>;

template <class Number>
LineLineScale<Number> validated_line_line(const Line2<Number>& a, const Line2<Number>& b) {
  const LineLineScale<Number> n({a.p.x, a.p.y, a.q.x, a.q.y, b.p.x, b.p.y, b.q.x, b.q.y});
  const auto is_point = [](const Line2<Number>& line) { return line.p == line.q; };
  if (!n.finite() || is_point(a) || is_point(b)) validation::validate_all("a", a, "b", b);  // names the field: slower
  return n;
}

/// Homogeneous: a point (x : y : w), or the line of all (x : y : w) with product sum 0.
template <class Value>
struct Homogeneous {
  Value x, y, w;
};

Homogeneous<Wide> cross_product(const Homogeneous<Int128>& g, const Homogeneous<Int128>& h) {
  return {product(g.y, h.w) - product(g.w, h.y), product(g.w, h.x) - product(g.x, h.w),
          product(g.x, h.y) - product(g.y, h.x)};
}

Homogeneous<Integer> cross_product(const Homogeneous<Integer>& g, const Homogeneous<Integer>& h) {
  return {Integer(g.y * h.w - g.w * h.y), Integer(g.w * h.x - g.x * h.w), Integer(g.x * h.y - g.y * h.x)};
}

/// The cross product of (p.x : p.y : 1) and (q.x : q.y : 1).
template <class Value>
Homogeneous<Value> line_through(const Point2<Value>& p, const Point2<Value>& q) {
  return {Value(p.y - q.y), Value(q.x - p.x), Value(p.x * q.y - p.y * q.x)};
}

template <class Value>
struct Lines {
  Line2<Value> a, b;
  decltype(cross_product(Homogeneous<Value>(), Homogeneous<Value>())) meet;
};

template <class Value, class Number>
Lines<Value> intersect(const LineLineScale<Number>& n) {
  const Line2<Value> a{integer_point<Value>(n, 0), integer_point<Value>(n, 2)};
  const Line2<Value> b{integer_point<Value>(n, 4), integer_point<Value>(n, 6)};
  return {a, b, cross_product(line_through(a.p, a.q), line_through(b.p, b.q))};
}

Int128 narrow(const Wide& value) { return static_cast<Int128>(value.low); }
const Integer& narrow(const Integer& value) { return value; }

/// t of p + t (q - p) = (x/w, y/w) by one coordinate that varies: x - p.x w is a multiple of q.x - p.x there.
template <class Value, class Coordinate>
Rational parameter_line_line(const Coordinate& meet, const Value& w, const Value& from, const Value& to) {
  const ExactDivision<Value> divide(Value(to - from));
  return quotient(divide(Coordinate(meet - product(from, w))), w);
}

template <class Value>
Rational parameter_line_line(const Lines<Value>& s, const Line2<Value>& line) {
  const Value w = narrow(s.meet.w);
  return line.p.x != line.q.x ? parameter_line_line(s.meet.x, w, line.p.x, line.q.x)
                              : parameter_line_line(s.meet.y, w, line.p.y, line.q.y);
}

template <class Value, class Number>
Certificate certificate_line_line(const LineLineScale<Number>& n, const Lines<Value>& s) {
  const Vector2<Value> direction = s.a.q - s.a.p;
  if (sgn(s.meet.w) != 0)
    return {"transversal", {{"determinant", {n.actual(rational(cross(direction, s.b.q - s.b.p)), 2)}}}};
  if (sgn(s.meet.x) != 0 || sgn(s.meet.y) != 0)
    return {"level_lines", {{"normal", {rational(Value(-direction.y)), rational(direction.x)}}}};
  const auto on_a = [&s, &direction](const Point2<Value>& p) {
    const Vector2<Value> from = p - s.a.p;
    return sgn(direction.x) != 0 ? quotient(from.x, direction.x) : quotient(from.y, direction.y);
  };
  return {"same_line", {{"on_a", {on_a(s.b.p), on_a(s.b.q)}}}};
}

template <class Value, class Number>
Truth<LineLine<Rational>> solved_line_line(const LineLineScale<Number>& n, const Lines<Value>& s) {
  if (sgn(s.meet.w) == 0) {
    const bool same = sgn(s.meet.x) == 0 && sgn(s.meet.y) == 0;
    return {{same ? LineRelation::same : LineRelation::parallel, {}, {}, {}}, Rational(0)};
  }
  Rational ta = parameter_line_line(s, s.a);
  Point2<Rational> point = actual_point(n, point_at(Segment2<Value>{s.a.p, s.a.q}, ta));
  return {{LineRelation::crossing, std::move(ta), parameter_line_line(s, s.b), std::move(point)},
          n.actual(absolute(s.meet.w), 2)};
}

template <class Value, class Number>
Truth<LineLine<Rational>> truth_line_line(const LineLineScale<Number>& n) {
  Lines<Value> s = intersect<Value>(n);
  Truth<LineLine<Rational>> found = solved_line_line(n, s);
  found.certificate = [n, s = std::move(s)] { return certificate_line_line(n, s); };
  return found;
}

}  // namespace

template <Exact Number>
Truth<LineLine<Rational>> line_line(const Line2<Number>& a, const Line2<Number>& b) {
  const LineLineScale<Number> n = validated_line_line(a, b);
  return n.bits() <= most_bits_in_words ? truth_line_line<Int128>(n) : truth_line_line<Integer>(n);
}
template Truth<LineLine<Rational>> line_line(const Line2d&, const Line2d&);
template Truth<LineLine<Rational>> line_line(const Line2<Rational>&, const Line2<Rational>&);

}  // namespace touchstone::oracle
