// SPDX-License-Identifier: Apache-2.0
#include "robust/lines/point_on_segment.h"

#include "robust/kernel/shapes/plane.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

using kernel::before;

/// On the segment's line, and between its ends in the order of the plane. Holds for a segment of length zero too.
template <class Integer>
Incidence relation_of(const Point2<Integer>& p, const Segment2<Integer>& s) {
  const bool reversed = before(s.b, s.a);
  const Point2<Integer>&first = reversed ? s.b : s.a, &last = reversed ? s.a : s.b;
  if (before(p, first) || before(last, p)) return Incidence::off;
  return kernel::turn(s.a, s.b, p) == 0 ? Incidence::on : Incidence::off;
}

template <class Integer, class Numbers>
Point2<Integer> point_in(const Numbers& n) {
  return {n[0], n[1]};
}
template <class Integer, class Numbers>
Segment2<Integer> segment_in(const Numbers& n) {
  return {{n[2], n[3]}, {n[4], n[5]}};
}

auto on_lattice(const Point2d& p, const Segment2d& s) {
  return kernel::lattice_of(p.x, p.y, s.a.x, s.a.y, s.b.x, s.b.y);
}
auto as_integers(const Point2d& p, const Segment2d& s) {
  return kernel::integers_of(p.x, p.y, s.a.x, s.a.y, s.b.x, s.b.y).at;
}

void validate_point_on_segment(const Point2d& point, const Segment2d& segment) {
  if (kernel::valid(point) && kernel::valid(segment)) return;
  validation::validate("point", point), validation::validate("segment", segment);
}

}  // namespace

Perhaps<Incidence> stages::point_on_segment::decision::lattice(const Point2d& point, const Segment2d& segment) {
  const auto lattice = on_lattice(point, segment);
  if (!lattice) return std::nullopt;
  return relation_of(point_in<std::int64_t>(lattice->at), segment_in<std::int64_t>(lattice->at));
}

Incidence stages::point_on_segment::decision::exact(const Point2d& point, const Segment2d& segment) {
  const auto n = as_integers(point, segment);
  return relation_of(point_in<mpz_class>(n), segment_in<mpz_class>(n));
}

/// Numbers on a lattice are finite, so nothing needs validation before.
Decided<Incidence> stages::point_on_segment::decision::past_filter(const Point2d& point, const Segment2d& segment) {
  return in_turn<decision, Stage::lattice, validate_point_on_segment, Stage::exact>(point, segment);
}

namespace {

template <class Integer>
PointOnSegment<double> answer_of(const Point2<Integer>& p, const Segment2<Integer>& s) {
  if (relation_of(p, s) == Incidence::off) return {Incidence::off, std::nullopt};
  return {Incidence::on, kernel::parameter_on(p, s)};
}

}  // namespace

Perhaps<PointOnSegment<double>> stages::point_on_segment::lattice(const Point2d& point, const Segment2d& segment) {
  const auto lattice = on_lattice(point, segment);
  if (!lattice) return std::nullopt;
  return answer_of(point_in<std::int64_t>(lattice->at), segment_in<std::int64_t>(lattice->at));
}

PointOnSegment<double> stages::point_on_segment::exact(const Point2d& point, const Segment2d& segment) {
  const auto n = as_integers(point, segment);
  return answer_of(point_in<mpz_class>(n), segment_in<mpz_class>(n));
}

/// If the filter answers, the numbers are constructed here: copying them costs more than deciding.
PointOnSegment<double> point_on_segment(const Point2d& point, const Segment2d& segment) {
  using decision = stages::point_on_segment::decision;
  if (decision::filter(point, segment)) return {Incidence::off, std::nullopt};
  return answer_in_turn<stages::point_on_segment, Stage::lattice, validate_point_on_segment, Stage::exact>(point,
                                                                                                           segment);
}

}  // namespace touchstone::robust
