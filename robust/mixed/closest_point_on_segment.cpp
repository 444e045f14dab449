// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/closest_point_on_segment.h"

#include "robust/kernel/enclosed/enclosed_nearest.h"
#include "robust/kernel/shapes/nearest_points.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

template <class Point, class Segment>
void validate_closest_point_on_segment(const Point& point, const Segment& segment) {
  if (kernel::valid(point) && kernel::valid(segment)) return;
  validation::validate_numbers("point", point), validation::validate_numbers("segment", segment);
}

}  // namespace

Perhaps<ClosestPoint2<double>> stages::closest_point_on_segment::enclosed(const Point2d& point,
                                                                          const Segment2d& segment) {
  return kernel::in_plane(enclosed(kernel::in_space(point), kernel::in_space(segment)));
}
Perhaps<ClosestPoint3<double>> stages::closest_point_on_segment::enclosed(const Point3d& point,
                                                                          const Segment3d& segment) {
  if (!(filters::moderate(point) & filters::moderate(segment))) return std::nullopt;
  return kernel::closest_point(filters::nearest_parts(segment, point));
}

ClosestPoint2<double> stages::closest_point_on_segment::exact(const Point2d& point, const Segment2d& segment) {
  return kernel::in_plane(exact(kernel::in_space(point), kernel::in_space(segment)));
}
ClosestPoint3<double> stages::closest_point_on_segment::exact(const Point3d& point, const Segment3d& segment) {
  const auto [at, exponent] = kernel::integer_points(point, segment.a, segment.b);
  return kernel::closest_point(at[0], kernel::nearest_on_segment(at[0], {at[1], at[2]}), exponent);
}

Decided<ClosestPoint2<double>> stages::closest_point_on_segment::ask(const Point2d& point, const Segment2d& segment) {
  return in_turn<stages::closest_point_on_segment, Stage::enclosed,
                 validate_closest_point_on_segment<Point2d, Segment2d>, Stage::exact>(point, segment);
}
Decided<ClosestPoint3<double>> stages::closest_point_on_segment::ask(const Point3d& point, const Segment3d& segment) {
  return in_turn<stages::closest_point_on_segment, Stage::enclosed,
                 validate_closest_point_on_segment<Point3d, Segment3d>, Stage::exact>(point, segment);
}

ClosestPoint2<double> closest_point_on_segment(const Point2d& point, const Segment2d& segment) {
  return stages::closest_point_on_segment::ask(point, segment).answer;
}
ClosestPoint3<double> closest_point_on_segment(const Point3d& point, const Segment3d& segment) {
  return stages::closest_point_on_segment::ask(point, segment).answer;
}

}  // namespace touchstone::robust
