// SPDX-License-Identifier: Apache-2.0
#include "robust/lines/segment_segment.h"

#include "robust/kernel/enclosed/enclosed_shapes.h"
#include "robust/kernel/shapes/plane.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

using kernel::before;

/// The relation of two segments; on_one_line: all four ends are collinear (or coincide).
struct MeetingSegments {
  SegmentRelation relation;
  bool on_one_line;
};

/// The ends of a segment in lexicographic order.
template <class Integer>
Segment2<Integer> in_order(const Segment2<Integer>& s) {
  return before(s.b, s.a) ? Segment2<Integer>{s.b, s.a} : s;
}

/// The intersection of two collinear segments, empty if its ends come out in the wrong order. A segment of length zero
/// is its point.
template <class Integer>
Segment2<Integer> common_part(const Segment2<Integer>& a, const Segment2<Integer>& b) {
  const Segment2<Integer> first = in_order(a), second = in_order(b);
  return {before(first.a, second.a) ? second.a : first.a, before(second.b, first.b) ? second.b : first.b};
}

template <class Integer>
MeetingSegments meeting_of(const Segment2<Integer>& a, const Segment2<Integer>& b) {
  const int ba = kernel::turn(a.a, a.b, b.a), bb = kernel::turn(a.a, a.b, b.b);
  if (ba * bb > 0) return {SegmentRelation::disjoint, false};
  const int aa = kernel::turn(b.a, b.b, a.a), ab = kernel::turn(b.a, b.b, a.b);
  if (aa * ab > 0) return {SegmentRelation::disjoint, false};
  // If both are zero, so are the others: a point that is not on the line of b turns equally twice for it and has
  // returned above.
  if (ba != 0 || bb != 0) return {SegmentRelation::point, false};
  const Segment2<Integer> common = common_part(a, b);
  if (before(common.b, common.a)) return {SegmentRelation::disjoint, true};
  return {before(common.a, common.b) ? SegmentRelation::overlap : SegmentRelation::point, true};
}

template <class Integer, class Numbers>
Segment2<Integer> first_segment_in(const Numbers& n) {
  return {{n[0], n[1]}, {n[2], n[3]}};
}
template <class Integer, class Numbers>
Segment2<Integer> second_segment_in(const Numbers& n) {
  return {{n[4], n[5]}, {n[6], n[7]}};
}

auto on_lattice(const Segment2d& a, const Segment2d& b) {
  return kernel::lattice_of(a.a.x, a.a.y, a.b.x, a.b.y, b.a.x, b.a.y, b.b.x, b.b.y);
}
auto as_integers(const Segment2d& a, const Segment2d& b) {
  return kernel::integers_of(a.a.x, a.a.y, a.b.x, a.b.y, b.a.x, b.a.y, b.b.x, b.b.y);
}

void validate_segment_segment(const Segment2d& a, const Segment2d& b) {
  if (kernel::valid(a) && kernel::valid(b)) return;
  validation::validate("a", a), validation::validate("b", b);
}

/// Compares the filter's boxes; refuses numbers that are not finite.
bool apart(const Segment2d& a, const Segment2d& b) {
  if (!filters::apart(a, b)) return false;
  validate_segment_segment(a, b);
  return true;
}

}  // namespace

Perhaps<SegmentRelation> stages::segment_segment::decision::lattice(const Segment2d& a, const Segment2d& b) {
  const auto lattice = on_lattice(a, b);
  if (!lattice) return std::nullopt;
  return meeting_of(first_segment_in<std::int64_t>(lattice->at), second_segment_in<std::int64_t>(lattice->at)).relation;
}

SegmentRelation stages::segment_segment::decision::exact(const Segment2d& a, const Segment2d& b) {
  const auto n = as_integers(a, b).at;
  return meeting_of(first_segment_in<mpz_class>(n), second_segment_in<mpz_class>(n)).relation;
}

/// Numbers on a lattice are finite, so nothing needs validation before.
Decided<SegmentRelation> stages::segment_segment::decision::past_filter(const Segment2d& a, const Segment2d& b) {
  if (apart(a, b)) return {SegmentRelation::disjoint, Stage::filter};
  return in_turn<decision, Stage::lattice, validate_segment_segment, Stage::exact>(a, b);
}

/// The numbers, if the filter says that the segments cross.
Perhaps<SegmentSegment<double>> stages::segment_segment::enclosed(const Segment2d& a, const Segment2d& b) {
  if (filters::segments(a, b) != filters::Sign::negative) return std::nullopt;
  using kernel::Two;
  if (!kernel::in_window(Two(a.a), Two(a.b), Two(b.a), Two(b.b))) return std::nullopt;
  if (!kernel::rounds_to_nearest()) return std::nullopt;
  const auto crossing = kernel::crossing_of(a, b);
  if (!crossing) return std::nullopt;
  return {in_place, SegmentRelation::point, crossing->ta, crossing->tb, crossing->point, std::nullopt};
}

namespace {

template <class Integer>
SegmentSegment<double> answer_of(const Segment2<Integer>& a, const Segment2<Integer>& b, int exponent) {
  const auto [relation, on_one_line] = meeting_of(a, b);
  SegmentSegment<double> answer{relation, {}, {}, {}, {}};
  if (relation == SegmentRelation::disjoint) return answer;
  if (!on_one_line) {
    const Vector2<Integer> r = a.b - a.a, s = b.b - b.a, between = b.a - a.a;
    const kernel::Second<Integer> d = kernel::determinant(r, s), na = kernel::determinant(between, s),
                                  nb = kernel::determinant(between, r);
    answer.ta = kernel::round_quotient(na, d);
    answer.tb = kernel::round_quotient(nb, d);
    answer.point = kernel::point_along(a.a, r, na, d, exponent);
    return answer;
  }
  const Segment2<Integer> common = common_part(a, b);
  if (relation == SegmentRelation::point) {
    answer.ta = kernel::parameter_on(common.a, a);
    answer.tb = kernel::parameter_on(common.a, b);
    answer.point = Point2d{kernel::round_scaled(common.a.x, exponent), kernel::round_scaled(common.a.y, exponent)};
  } else {
    answer.overlap =
        Segment2d{{kernel::round_scaled(common.a.x, exponent), kernel::round_scaled(common.a.y, exponent)},
                  {kernel::round_scaled(common.b.x, exponent), kernel::round_scaled(common.b.y, exponent)}};
  }
  return answer;
}

}  // namespace

Perhaps<SegmentSegment<double>> stages::segment_segment::lattice(const Segment2d& a, const Segment2d& b) {
  const auto lattice = on_lattice(a, b);
  if (!lattice) return std::nullopt;
  return answer_of(first_segment_in<std::int64_t>(lattice->at), second_segment_in<std::int64_t>(lattice->at),
                   lattice->exponent);
}

SegmentSegment<double> stages::segment_segment::exact(const Segment2d& a, const Segment2d& b) {
  const auto n = as_integers(a, b);
  return answer_of(first_segment_in<mpz_class>(n.at), second_segment_in<mpz_class>(n.at), n.exponent);
}

/// If the filter answers, the numbers are constructed here: copying them costs more than deciding.
SegmentSegment<double> segment_segment(const Segment2d& a, const Segment2d& b) {
  using decision = stages::segment_segment::decision;
  const auto relation = decision::filter(a, b);
  if (relation ? *relation == SegmentRelation::disjoint : apart(a, b))
    return {SegmentRelation::disjoint, {}, {}, {}, {}};
  if (relation)
    return answer_in_turn<stages::segment_segment, Stage::enclosed, Stage::lattice, validate_segment_segment,
                          Stage::exact>(a, b);
  return answer_in_turn<stages::segment_segment, Stage::lattice, validate_segment_segment, Stage::exact>(a, b);
}

}  // namespace touchstone::robust
