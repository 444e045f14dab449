// SPDX-License-Identifier: Apache-2.0
#include "oracle/lines/segment_segment.h"

#include <utility>

#include "oracle/exact/common_points.h"
#include "oracle/exact/common_scale.h"
#include "oracle/exact/rational_door.h"

namespace touchstone::oracle {
namespace {

template <class Number>
CommonScale<Number, 8> admitted(const Segment2<Number>& a, const Segment2<Number>& b) {
  const CommonScale<Number, 8> numbers({a.a.x, a.a.y, a.b.x, a.b.y, b.a.x, b.a.y, b.b.x, b.b.y});
  if (!numbers.finite()) door::admit("a", a), door::admit("b", b);  // names the field: far slower than the question
  return numbers;
}

template <class Number>
struct Solved {
  CommonScale<Number, 8> scale;
  Segment2<Integer> a, b;
  CommonPoints common;
};

template <class Number>
Solved<Number> solve(const Segment2<Number>& a, const Segment2<Number>& b) {
  const CommonScale<Number, 8> n = admitted(a, b);
  const Segment2<Integer> whole_a = whole_segment(n, 0), whole_b = whole_segment(n, 4);
  return {n, whole_a, whole_b, common_points(whole_a, Extent::segment, whole_b, n.bits())};
}

bool at_end(const Rational& t) { return t == 0 || t == 1; }
bool zero_length(const Segment2<Integer>& s) { return s.a == s.b; }

template <class Number>
Truth<SegmentSegment<Rational>> truth(const Solved<Number>& s) {
  const auto end_distance = [&s] { return s.scale.actual(least_end_distance(s.a, Extent::segment, s.b), 2); };
  if (!s.common.any) return {{SegmentRelation::disjoint, {}, {}, {}, {}}, end_distance()};
  const Rational &ta = s.common.first, &tb = s.common.second_at_first;
  const Point2<Rational> first = actual_point(s.scale, point_at(s.a, ta));
  if (s.common.first < s.common.last) {
    const Point2<Rational> last = actual_point(s.scale, point_at(s.a, s.common.last));
    const bool in_order = first.x < last.x || (first.x == last.x && first.y < last.y);
    const Segment2<Rational> overlap = in_order ? Segment2<Rational>{first, last} : Segment2<Rational>{last, first};
    return {{SegmentRelation::overlap, {}, {}, {}, overlap}, Rational(0)};
  }
  const bool touching = at_end(ta) || at_end(tb);
  return {{SegmentRelation::point, ta, tb, first, {}}, touching ? Rational(0) : end_distance()};
}

}  // namespace

Truth<SegmentSegment<Rational>> segment_segment(const Segment2d& a, const Segment2d& b) { return truth(solve(a, b)); }

template <Exact Number>
Truth<SegmentSegment<Rational>> segment_segment(const Segment2<Number>& a, const Segment2<Number>& b) {
  return truth(solve(a, b));
}
template Truth<SegmentSegment<Rational>> segment_segment(const Segment2<Rational>&, const Segment2<Rational>&);

Certificate segment_segment_certificate(const Segment2d& a, const Segment2d& b) {
  const Solved<double> s = solve(a, b);
  const CommonPoints& common = s.common;
  const auto line = [&](const char* kind, const Vector2<Integer>& normal) {
    const Rational offset = s.scale.actual(halfway(normal, s.a, Extent::segment, s.b), 1);
    return Certificate{kind, {{"normal", {Rational(normal.x), Rational(normal.y)}}, {"offset", {offset}}}};
  };
  if (!common.any) {
    return line("separating_line", common.normal);
  }
  if (common.first < common.last) {
    Rational on_a[2] = {common.first, common.last}, on_b[2] = {common.second_at_first, common.second_at_last};
    const Vector2<Integer> u = s.a.b - s.a.a;
    if (sgn(u.x) < 0 || (sgn(u.x) == 0 && sgn(u.y) < 0)) std::swap(on_a[0], on_a[1]), std::swap(on_b[0], on_b[1]);
    return {"overlap", {{"on_a", {on_a[0], on_a[1]}}, {"on_b", {on_b[0], on_b[1]}}}};
  }
  if (zero_length(s.a) || zero_length(s.b)) return {"single_point", {}};
  const Vector2<Integer> u = s.a.b - s.a.a, v = s.b.b - s.b.a;
  const Integer area = cross(u, v);
  if (sgn(area) != 0) return {"transversal", {{"determinant", {s.scale.actual(area, 2)}}}};
  // Collinear, end to end: a normal along the line, from a to b, has the common point as its only one on both sides.
  const Vector2<Integer> along = common.first == 0 ? Vector2<Integer>{Integer(-u.x), Integer(-u.y)} : u;
  return line("supporting_line", along);
}

SegmentRelation segment_segment_relation(const Segment2d& a, const Segment2d& b) {
  const CommonScale<double, 8> n = admitted(a, b);
  if (n.bits() <= 61) {
    using Words = Segment2<std::int64_t>;
    return segment_segment_relation<Int128>(Words{{n.word(0), n.word(1)}, {n.word(2), n.word(3)}},
                                            Words{{n.word(4), n.word(5)}, {n.word(6), n.word(7)}});
  }
  return segment_segment_relation<Integer>(whole_segment(n, 0), whole_segment(n, 4));
}

}  // namespace touchstone::oracle
