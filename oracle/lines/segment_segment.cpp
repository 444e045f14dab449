// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/segment_segment.h"

#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/common_scale.h"
#include "oracle/exact/systems/common_points.h"

namespace touchstone::oracle {
namespace {

template <class Number>
CommonScale<Number, 8> validated_segment_segment(const Segment2<Number>& a, const Segment2<Number>& b) {
  const CommonScale<Number, 8> numbers({a.a.x, a.a.y, a.b.x, a.b.y, b.a.x, b.a.y, b.b.x, b.b.y});
  if (!numbers.finite())
    validation::validate("a", a), validation::validate("b", b);  // names the field: far slower than the question
  return numbers;
}

template <class Value>
struct SegmentSegmentSolved {
  template <class Number>
  explicit SegmentSegmentSolved(const CommonScale<Number, 8>& n)
      : a(integer_segment<Value>(n, 0)), b(integer_segment<Value>(n, 4)), common(a, Extent::segment, b) {}

  Segment2<Value> a, b;
  CommonPoints<Value> common;
};

template <class Value>
bool at_end(const Fraction<Value>& t) {
  return sgn(t.numerator) == 0 || t.numerator == t.denominator;
}

template <class Value, class Number>
Certificate certificate_segment_segment(const CommonScale<Number, 8>& n, const SegmentSegmentSolved<Value>& s) {
  const CommonPoints<Value>& common = s.common;
  const auto line = [&](const char* kind, const Vector2<Value>& normal) {
    const Rational offset = n.actual(halfway(normal, s.a, Extent::segment, s.b), 1);
    return Certificate{kind, {{"normal", {rational(normal.x), rational(normal.y)}}, {"offset", {offset}}}};
  };
  if (!common.any) return line("separating_line", common.normal);
  const Vector2<Value> u = s.a.b - s.a.a, v = s.b.b - s.b.a;
  if (common.extended) {
    std::vector<Rational> on_a{rational(common.first), rational(common.last)},
        on_b{rational(common.second_at_first), rational(common.second_at_last)};
    if (sgn(u.x) < 0 || (sgn(u.x) == 0 && sgn(u.y) < 0)) std::swap(on_a[0], on_a[1]), std::swap(on_b[0], on_b[1]);
    return {"overlap", {{"on_a", on_a}, {"on_b", on_b}}};
  }
  if (s.a.a == s.a.b || s.b.a == s.b.b) return {"single_point", {}};
  const Value area = cross(u, v);
  if (sgn(area) != 0) return {"transversal", {{"determinant", {n.actual(rational(area), 2)}}}};
  // Collinear, end to end: a normal along the line, from a to b, has the common point as its only one on both sides.
  return line("supporting_line", sgn(common.first.numerator) == 0 ? Vector2<Value>{Value(-u.x), Value(-u.y)} : u);
}

template <class Value, class Number>
Truth<SegmentSegment<Rational>> solved_segment_segment(const CommonScale<Number, 8>& n,
                                                       const SegmentSegmentSolved<Value>& s) {
  const CommonPoints<Value>& common = s.common;
  const auto end_distance = [&] { return n.actual(least_end_distance(s.a, Extent::segment, s.b), 2); };
  if (!common.any) return {{SegmentRelation::disjoint, {}, {}, {}, {}}, end_distance()};
  Rational ta = rational(common.first);
  Point2<Rational> first = actual_point(n, point_at(s.a, ta));
  if (common.extended) {
    Point2<Rational> last = actual_point(n, point_at(s.a, rational(common.last)));
    if (last.x < first.x || (first.x == last.x && last.y < first.y)) std::swap(first, last);
    return {{SegmentRelation::overlap, {}, {}, {}, Segment2<Rational>{std::move(first), std::move(last)}}, Rational(0)};
  }
  const Fraction<Value>& tb = common.second_at_first;
  return {{SegmentRelation::point, std::move(ta), rational(tb), std::move(first), {}},
          at_end(common.first) || at_end(tb) ? Rational(0) : end_distance()};
}

template <class Value, class Number>
Truth<SegmentSegment<Rational>> truth_segment_segment(const CommonScale<Number, 8>& n) {
  SegmentSegmentSolved<Value> s(n);
  Truth<SegmentSegment<Rational>> found = solved_segment_segment(n, s);
  found.certificate = [n, s = std::move(s)] { return certificate_segment_segment(n, s); };
  return found;
}

}  // namespace

template <Exact Number>
Truth<SegmentSegment<Rational>> segment_segment(const Segment2<Number>& a, const Segment2<Number>& b) {
  const CommonScale<Number, 8> n = validated_segment_segment(a, b);
  return n.bits() <= most_bits_in_words ? truth_segment_segment<Int128>(n) : truth_segment_segment<Integer>(n);
}
template Truth<SegmentSegment<Rational>> segment_segment(const Segment2d&, const Segment2d&);
template Truth<SegmentSegment<Rational>> segment_segment(const Segment2<Rational>&, const Segment2<Rational>&);

SegmentRelation segment_segment_relation(const Segment2d& a, const Segment2d& b) {
  const CommonScale<double, 8> n = validated_segment_segment(a, b);
  if (n.bits() <= most_bits_in_words) {
    using Words = Segment2<std::int64_t>;
    return segment_segment_relation<Int128>(Words{{n.word(0), n.word(1)}, {n.word(2), n.word(3)}},
                                            Words{{n.word(4), n.word(5)}, {n.word(6), n.word(7)}});
  }
  return segment_segment_relation<Integer>(integer_segment(n, 0), integer_segment(n, 4));
}

}  // namespace touchstone::oracle
