// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/segment_segment_distance.h"

#include "geometry/validation.h"
#include "oracle/exact/shapes/nearest_pair.h"

namespace touchstone::oracle {
namespace {

template <class Segment>
NearestPair solved_segment_segment_distance(const Segment& a, const Segment& b) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
  return nearest_pair({exact_in_space(a.a), exact_in_space(a.b)}, {exact_in_space(b.a), exact_in_space(b.b)});
}

template <class Answer>
Truth<Answer> proved(Answer answer, const NearestPair& nearest) {
  return truth_of_distance(std::move(answer), nearest.squared_distance,
                           {{"on_a", nearest.weights_of_a}, {"on_b", nearest.weights_of_b}});
}

/// The point of a; the displacement to that of b is the same for all.
template <class Segment, class Pair, class Point>
std::pair<Point3<Rational>, Vector3<Rational>> moved_along(const Segment& a, const Segment& b, const Pair& truth,
                                                           const Point& on_a) {
  const Point3<Rational> from = rational(truth.on_a);
  const Vector3<Rational> displacement = rational(truth.on_b) - from;
  return {nearest_to(exact_in_space(on_a), {exact_in_space(a.a), exact_in_space(a.b)},
                     {exact_in_space(b.a), exact_in_space(b.b)}, from, displacement),
          displacement};
}

}  // namespace

ClosestPair2<Surd> as_near(const Segment2d& a, const Segment2d& b, const ClosestPair2<Surd>& truth,
                           const Point2d& on_a) {
  const auto [point, displacement] = moved_along(a, b, truth, on_a);
  return {in_plane(point), in_plane(point + displacement), truth.squared_distance, truth.distance};
}
ClosestPair3<Surd> as_near(const Segment3d& a, const Segment3d& b, const ClosestPair3<Surd>& truth,
                           const Point3d& on_a) {
  const auto [point, displacement] = moved_along(a, b, truth, on_a);
  return {in_space(point), in_space(point + displacement), truth.squared_distance, truth.distance};
}

template <Exact Number>
Truth<ClosestPair2<Surd>> segment_segment_distance(const Segment2<Number>& a, const Segment2<Number>& b) {
  const NearestPair nearest = solved_segment_segment_distance(a, b);
  return proved(ClosestPair2<Surd>{in_plane(nearest.on_a), in_plane(nearest.on_b), {}, {}}, nearest);
}
template <Exact Number>
Truth<ClosestPair3<Surd>> segment_segment_distance(const Segment3<Number>& a, const Segment3<Number>& b) {
  const NearestPair nearest = solved_segment_segment_distance(a, b);
  return proved(ClosestPair3<Surd>{in_space(nearest.on_a), in_space(nearest.on_b), {}, {}}, nearest);
}
template Truth<ClosestPair2<Surd>> segment_segment_distance(const Segment2d&, const Segment2d&);
template Truth<ClosestPair3<Surd>> segment_segment_distance(const Segment3d&, const Segment3d&);
template Truth<ClosestPair2<Surd>> segment_segment_distance(const Segment2<Rational>&, const Segment2<Rational>&);
template Truth<ClosestPair3<Surd>> segment_segment_distance(const Segment3<Rational>&, const Segment3<Rational>&);

}  // namespace touchstone::oracle
