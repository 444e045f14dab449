// SPDX-License-Identifier: Apache-2.0
#include "robust/lines/ray_segment.h"

#include "robust/kernel/enclosed/enclosed_shapes.h"
#include "robust/kernel/shapes/plane.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

/// A ray and a segment in integers: positions are multiples of 2^position, the direction of 2^direction.
template <class Integer>
struct Question {
  Point2<Integer> origin;
  Vector2<Integer> v;
  Segment2<Integer> segment;
  int position, direction;
};

/// The relation; on_one_line: both ends of the segment lie on the ray's line. Then `first` is the first common point.
template <class Integer>
struct Meeting {
  RayRelation relation;
  bool on_one_line;
  Segment2<Integer> common;
};

/// True if q comes after p on a line along v; both lie on it.
template <class Integer>
bool ahead(const Vector2<Integer>& v, const Point2<Integer>& p, const Point2<Integer>& q) {
  const int along = kernel::sign_of(v.x);
  if (along != 0) return along > 0 ? p.x < q.x : q.x < p.x;
  return v.y > 0 ? p.y < q.y : q.y < p.y;
}

template <class Integer>
Meeting<Integer> along_the_ray(const Question<Integer>& q) {
  const bool reversed = ahead(q.v, q.segment.b, q.segment.a);
  const Point2<Integer>&near = reversed ? q.segment.b : q.segment.a, &far = reversed ? q.segment.a : q.segment.b;
  if (ahead(q.v, far, q.origin)) return {RayRelation::none, true, {}};
  const Point2<Integer>& first = ahead(q.v, near, q.origin) ? q.origin : near;
  return {ahead(q.v, first, far) ? RayRelation::overlap : RayRelation::point, true, {first, far}};
}

template <class Integer>
Meeting<Integer> meeting_of(const Question<Integer>& q) {
  const int a = kernel::turn(q.v, q.segment.a - q.origin), b = kernel::turn(q.v, q.segment.b - q.origin);
  if (a * b > 0) return {RayRelation::none, false, {}};
  if (a == 0 && b == 0) return along_the_ray(q);
  // The line of the ray meets the segment once: at t = ((a - origin) x s) / (v x s), and the turn of b - a has the sign
  // of v x s.
  const int ahead = kernel::turn(q.segment.a - q.origin, q.segment.b - q.segment.a);
  return {ahead * (b - a) >= 0 ? RayRelation::point : RayRelation::none, false, {}};
}

std::optional<Question<std::int64_t>> on_lattice(const Ray2d& ray, const Segment2d& s) {
  const auto p = kernel::lattice_of(ray.origin.x, ray.origin.y, s.a.x, s.a.y, s.b.x, s.b.y);
  const auto v = kernel::lattice_of(ray.direction.x, ray.direction.y);
  if (!p || !v) return std::nullopt;
  const auto& n = p->at;
  return Question<std::int64_t>{
      {n[0], n[1]}, {v->at[0], v->at[1]}, {{n[2], n[3]}, {n[4], n[5]}}, p->exponent, v->exponent};
}

Question<mpz_class> as_integers(const Ray2d& ray, const Segment2d& s) {
  const auto p = kernel::integers_of(ray.origin.x, ray.origin.y, s.a.x, s.a.y, s.b.x, s.b.y);
  const auto v = kernel::integers_of(ray.direction.x, ray.direction.y);
  const auto& n = p.at;
  return {{n[0], n[1]}, {v.at[0], v.at[1]}, {{n[2], n[3]}, {n[4], n[5]}}, p.exponent, v.exponent};
}

void validate_ray_segment(const Ray2d& ray, const Segment2d& segment) {
  if (kernel::valid(ray) && kernel::valid(segment)) return;
  validation::validate_all("ray", ray, "segment", segment);
}

}  // namespace

Perhaps<RayRelation> stages::ray_segment::decision::lattice(const Ray2d& ray, const Segment2d& segment) {
  const auto question = on_lattice(ray, segment);
  if (!question) return std::nullopt;
  return meeting_of(*question).relation;
}

RayRelation stages::ray_segment::decision::exact(const Ray2d& ray, const Segment2d& segment) {
  return meeting_of(as_integers(ray, segment)).relation;
}

Decided<RayRelation> stages::ray_segment::decision::past_filter(const Ray2d& ray, const Segment2d& segment) {
  return in_turn<decision, validate_ray_segment, Stage::lattice, Stage::exact>(ray, segment);
}

/// The numbers, if the filter says that they meet in a point.
Perhaps<RaySegment<double>> stages::ray_segment::enclosed(const Ray2d& ray, const Segment2d& segment) {
  if (filters::ray(ray.origin, ray.direction, segment) != filters::Sign::negative) return std::nullopt;
  using namespace kernel;
  const Two origin(ray.origin), direction(ray.direction), a(segment.a), b(segment.b);
  if (!in_window(origin, direction, a, b) || !rounds_to_nearest()) return std::nullopt;
  const Factor<Two> v = factor(direction), s = vector_between(a, b);
  const Enclosed<Two> crosses = enclosed_crosses(s, v, vector_between(origin, a));
  const Enclosed<double> d = first(crosses);
  if (!crosses.settled() || d.high == 0) return std::nullopt;
  const Enclosed<double> t = second(crosses) / Divisor(d);
  const auto parameter = rounded(t);
  const auto point = rounded(along(origin, twice(t), v));
  if (!parameter || !point) return std::nullopt;
  return {in_place, RayRelation::point, *parameter, point_of(*point), std::nullopt};
}

namespace {

template <class Integer>
double parameter_of(const Point2<Integer>& p, const Question<Integer>& q) {
  using Wide = kernel::Second<Integer>;
  const int exponent = q.position - q.direction;
  if (kernel::sign_of(q.v.x) != 0) return kernel::round_quotient(Wide(p.x - q.origin.x), Wide(q.v.x), exponent);
  return kernel::round_quotient(Wide(p.y - q.origin.y), Wide(q.v.y), exponent);
}

template <class Integer>
Point2d rounded(const Point2<Integer>& p, int exponent) {
  return {kernel::round_scaled(p.x, exponent), kernel::round_scaled(p.y, exponent)};
}

template <class Integer>
RaySegment<double> answer_of(const Question<Integer>& q) {
  const Meeting<Integer> meeting = meeting_of(q);
  RaySegment<double> answer{meeting.relation, {}, {}, {}};
  if (meeting.relation == RayRelation::none) return answer;
  if (meeting.on_one_line) {
    answer.t = parameter_of(meeting.common.a, q);
    if (meeting.relation == RayRelation::point) answer.point = rounded(meeting.common.a, q.position);
    else answer.overlap = Segment2d{rounded(meeting.common.a, q.position), rounded(meeting.common.b, q.position)};
    return answer;
  }
  const Vector2<Integer> s = q.segment.b - q.segment.a, to_segment = q.segment.a - q.origin;
  const kernel::Second<Integer> d = kernel::determinant(q.v, s);
  answer.t = kernel::round_quotient(kernel::determinant(to_segment, s), d, q.position - q.direction);
  // Along the segment, whose numbers share one power of two: a + ((a - origin) x v / (v x s)) s.
  answer.point = kernel::point_along<Integer>(q.segment.a, s, kernel::determinant(to_segment, q.v), d, q.position);
  return answer;
}

}  // namespace

Perhaps<RaySegment<double>> stages::ray_segment::lattice(const Ray2d& ray, const Segment2d& segment) {
  const auto question = on_lattice(ray, segment);
  if (!question) return std::nullopt;
  return answer_of(*question);
}

RaySegment<double> stages::ray_segment::exact(const Ray2d& ray, const Segment2d& segment) {
  return answer_of(as_integers(ray, segment));
}

/// If the filter answers, the numbers are constructed here: copying them costs more than deciding.
RaySegment<double> ray_segment(const Ray2d& ray, const Segment2d& segment) {
  using decision = stages::ray_segment::decision;
  const auto relation = decision::filter(ray, segment);
  if (relation && *relation == RayRelation::none) return {RayRelation::none, {}, {}, {}};
  if (relation)
    return answer_in_turn<stages::ray_segment, Stage::enclosed, validate_ray_segment, Stage::lattice, Stage::exact>(
        ray, segment);
  return answer_in_turn<stages::ray_segment, validate_ray_segment, Stage::lattice, Stage::exact>(ray, segment);
}

}  // namespace touchstone::robust
