// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/closest_point_on_segment.h"

#include "robust/kernel/nearest_points.h"
#include "robust/kernel/valid_capsules.h"

namespace touchstone::robust {
namespace {

template <class Point, class Segment>
ClosestPoint3<double> closest_in_space(const Point& point, const Segment& segment) {
  if (!kernel::valid(point) || !kernel::valid(segment))
    validation::validate_numbers("point", point), validation::validate_numbers("segment", segment);
  const auto [at, exponent] = kernel::whole_points(point, segment.a, segment.b);
  return kernel::closest_point(at[0], kernel::nearest_on_segment(at[0], {at[1], at[2]}), exponent);
}

}  // namespace

ClosestPoint2<double> closest_point_on_segment(const Point2d& point, const Segment2d& segment) {
  return kernel::in_plane(closest_in_space(point, segment));
}
ClosestPoint3<double> closest_point_on_segment(const Point3d& point, const Segment3d& segment) {
  return closest_in_space(point, segment);
}

}  // namespace touchstone::robust
