// SPDX-License-Identifier: Apache-2.0
#include "robust/polyhedra/segment_triangle.h"

#include "geometry/validation.h"
#include "robust/kernel/enclosed/enclosed_crossing.h"
#include "robust/kernel/integers/integers.h"
#include "robust/kernel/integers/rounding.h"
#include "robust/kernel/shapes/triangle_clip.h"
#include "robust/kernel/shapes/valid.h"
#include "robust/kernel/solids/small_hulls.h"

namespace touchstone::robust {
namespace {

using kernel::Clipped;
using Relation = SegmentTriangleRelation;

/// The question in integers times 2^exponent.
struct Question {
  Segment3<mpz_class> segment;
  Triangle3<mpz_class> triangle;
  int exponent;
};

Question as_integers(const Segment3d& s, const Triangle3d& t) {
  const auto integers = kernel::integers_of(s.a.x, s.a.y, s.a.z, s.b.x, s.b.y, s.b.z, t.a.x, t.a.y, t.a.z, t.b.x, t.b.y,
                                            t.b.z, t.c.x, t.c.y, t.c.z);
  const auto& n = integers.at;
  const auto point = [&n](std::size_t i) { return Point3<mpz_class>{n[i], n[i + 1], n[i + 2]}; };
  return {{point(0), point(3)}, {point(6), point(9), point(12)}, integers.exponent};
}

Relation relation_of(const Segment3<mpz_class>& segment, const Clipped& part) {
  if (part.empty) return Relation::none;
  return segment.a == segment.b || !(part.first < part.last) ? Relation::point : Relation::segment;
}

/// The segment's point at t, rounded.
Point3d rounded(const Question& q, const Clipped::Parameter& t) {
  const auto& [a, b] = q.segment;
  const auto coordinate = [&](const mpz_class& from, const mpz_class& to) {
    return kernel::round_quotient(mpz_class(t.denominator * from + t.numerator * (to - from)), t.denominator,
                                  q.exponent);
  };
  return {coordinate(a.x, b.x), coordinate(a.y, b.y), coordinate(a.z, b.z)};
}

void validate_segment_triangle(const Segment3d& s, const Triangle3d& t) {
  using kernel::valid;
  if (valid(s.a) && valid(s.b) && valid(t.a) && valid(t.b) && valid(t.c)) return;
  validation::validate_numbers("segment", s), validation::validate_numbers("triangle", t);
}

}  // namespace

/// Every sign is that of FacePlane.
Perhaps<Relation> stages::segment_triangle::decision::by_planes(const Segment3d& segment, const Triangle3d& triangle) {
  using filters::Sign;
  using Plane = filters::FacePlane<double>;
  const auto& [p, q] = segment;
  const auto& [a, b, c] = triangle;
  const Plane plane(a, b, c);
  const Sign at_p = plane.side(p), at_q = plane.side(q);
  if (at_p == Sign::unknown || at_q == Sign::unknown) return std::nullopt;
  if (at_p == at_q) return Relation::none;
  const Sign ab = Plane(p, q, a).side(b), bc = Plane(p, q, b).side(c), ca = Plane(p, q, c).side(a);
  const auto any = [&](Sign sign) { return ab == sign || bc == sign || ca == sign; };
  if (any(Sign::positive) && any(Sign::negative)) return Relation::none;
  if (any(Sign::unknown)) return std::nullopt;
  return Relation::point;
}

Perhaps<Relation> stages::segment_triangle::decision::lattice(const Segment3d& segment, const Triangle3d& triangle) {
  const auto dimension = kernel::common_dimension_on_lattice(segment, triangle);
  if (!dimension) return std::nullopt;
  return static_cast<Relation>(1 + *dimension);
}

Relation stages::segment_triangle::decision::exact(const Segment3d& segment, const Triangle3d& triangle) {
  return static_cast<Relation>(1 + kernel::common_dimension_in_integers(segment, triangle));
}

Decided<Relation> stages::segment_triangle::decision::past_filter(const Segment3d& segment,
                                                                  const Triangle3d& triangle) {
  if (const auto known = by_planes(segment, triangle)) return {*known, Stage::filter};
  return in_turn<decision, validate_segment_triangle, Stage::lattice, Stage::exact>(segment, triangle);
}

Perhaps<SegmentTriangle<double>> stages::segment_triangle::enclosed(const Segment3d& segment,
                                                                    const Triangle3d& triangle) {
  auto relation = decision::filter(segment, triangle);
  if (!relation) relation = decision::by_planes(segment, triangle);
  if (!relation) return std::nullopt;
  if (*relation == Relation::none) return SegmentTriangle<double>{Relation::none, {}, {}, {}};
  if (!kernel::crossable(segment.a, segment.b, triangle.a, triangle.b, triangle.c)) return std::nullopt;
  const auto found = kernel::crossing(segment.a, kernel::loose_between(segment.a, segment.b), triangle);
  if (!found) return std::nullopt;
  return SegmentTriangle<double>{Relation::point, (*found).t, (*found).point, {}};
}

SegmentTriangle<double> stages::segment_triangle::exact(const Segment3d& segment, const Triangle3d& triangle) {
  const Question q = as_integers(segment, triangle);
  const Clipped part = kernel::clipped(q.segment, q.triangle);
  SegmentTriangle<double> answer{relation_of(q.segment, part), {}, {}, {}};
  if (answer.relation == Relation::point) {
    answer.t = kernel::round_quotient(part.first.numerator, part.first.denominator);
    answer.point = rounded(q, part.first);
  } else if (answer.relation == Relation::segment) {
    answer.overlap = Segment3d{rounded(q, part.first), rounded(q, part.last)};
  }
  return answer;
}

SegmentTriangle<double> segment_triangle(const Segment3d& segment, const Triangle3d& triangle) {
  return answer_in_turn<stages::segment_triangle, Stage::enclosed, validate_segment_triangle, Stage::exact>(segment,
                                                                                                            triangle);
}

}  // namespace touchstone::robust
