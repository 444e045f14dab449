// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/closest_point_on_segment.h"

#include "geometry/validation.h"
#include "oracle/exact/shapes/nearest_pair.h"

namespace touchstone::oracle {
namespace {

template <class Point, class Segment>
NearestPair solved_closest_point_on_segment(const Point& point, const Segment& segment) {
  validation::validate_numbers("point", point), validation::validate_numbers("segment", segment);
  return nearest_pair({exact_in_space(segment.a), exact_in_space(segment.b)}, {exact_in_space(point)});
}

}  // namespace

template <Exact Number>
Truth<ClosestPoint2<Surd>> closest_point_on_segment(const Point2<Number>& point, const Segment2<Number>& segment) {
  const NearestPair nearest = solved_closest_point_on_segment(point, segment);
  return truth_of_distance(ClosestPoint2<Surd>{in_plane(nearest.on_a), {}, {}}, nearest.squared_distance,
                           {{"weights", nearest.weights_of_a}});
}
template <Exact Number>
Truth<ClosestPoint3<Surd>> closest_point_on_segment(const Point3<Number>& point, const Segment3<Number>& segment) {
  const NearestPair nearest = solved_closest_point_on_segment(point, segment);
  return truth_of_distance(ClosestPoint3<Surd>{in_space(nearest.on_a), {}, {}}, nearest.squared_distance,
                           {{"weights", nearest.weights_of_a}});
}
template Truth<ClosestPoint2<Surd>> closest_point_on_segment(const Point2d&, const Segment2d&);
template Truth<ClosestPoint3<Surd>> closest_point_on_segment(const Point3d&, const Segment3d&);
template Truth<ClosestPoint2<Surd>> closest_point_on_segment(const Point2<Rational>&, const Segment2<Rational>&);
template Truth<ClosestPoint3<Surd>> closest_point_on_segment(const Point3<Rational>&, const Segment3<Rational>&);

}  // namespace touchstone::oracle
