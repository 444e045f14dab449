// SPDX-License-Identifier: Apache-2.0
#include "robust/volumes/closest_point_on_obb.h"

#include "robust/kernel/enclosed/enclosed_in_obb.h"
#include "robust/kernel/shapes/nearest_points.h"
#include "robust/kernel/solids/parallelepiped.h"

namespace touchstone::robust {
namespace {

void validate_closest_point_on_obb(const Point3d& point, const Obb3d& obb) {
  kernel::validate_with_obb("point", point, "obb", obb);
}

}  // namespace

Perhaps<ClosestPoint3<double>> stages::closest_point_on_obb::enclosed(const Point3d& point, const Obb3d& obb) {
  return kernel::closest_in_obb(point, obb);
}

ClosestPoint3<double> stages::closest_point_on_obb::exact(const Point3d& point, const Obb3d& obb) {
  const auto& [u, v, w] = obb.half_axes;
  const auto [at, exponent] = kernel::integer_points(point, obb.center, u, v, w);
  return kernel::closest_point(at[0], kernel::nearest_in_box(at[0], kernel::box_of(at, 1)), exponent);
}

Decided<ClosestPoint3<double>> stages::closest_point_on_obb::ask(const Point3d& point, const Obb3d& obb) {
  return in_turn<closest_point_on_obb, validate_closest_point_on_obb, Stage::enclosed, Stage::exact>(point, obb);
}

ClosestPoint3<double> closest_point_on_obb(const Point3d& point, const Obb3d& obb) {
  return stages::closest_point_on_obb::ask(point, obb).answer;
}

}  // namespace touchstone::robust
