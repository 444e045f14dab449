// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/closest_point_on_triangle.h"

#include "robust/kernel/enclosed/enclosed_nearest.h"
#include "robust/kernel/shapes/nearest_points.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

void validate_closest_point_on_triangle(const Point3d& point, const Triangle3d& triangle) {
  if (kernel::valid(point) && kernel::valid(triangle)) return;
  validation::validate_numbers("point", point), validation::validate_numbers("triangle", triangle);
}

}  // namespace

Perhaps<ClosestPoint3<double>> stages::closest_point_on_triangle::enclosed(const Point3d& point,
                                                                           const Triangle3d& triangle) {
  if (!(filters::moderate(point) & filters::moderate(triangle))) return std::nullopt;
  return kernel::closest_point(filters::nearest_parts(triangle, point));
}

ClosestPoint3<double> stages::closest_point_on_triangle::exact(const Point3d& point, const Triangle3d& triangle) {
  const auto& [a, b, c] = triangle;
  const auto [at, exponent] = kernel::integer_points(point, a, b, c);
  return kernel::closest_point(at[0], kernel::nearest_on_triangle(at[0], {at[1], at[2], at[3]}), exponent);
}

Decided<ClosestPoint3<double>> stages::closest_point_on_triangle::ask(const Point3d& point,
                                                                      const Triangle3d& triangle) {
  return in_turn<closest_point_on_triangle, Stage::enclosed, validate_closest_point_on_triangle, Stage::exact>(
      point, triangle);
}

ClosestPoint3<double> closest_point_on_triangle(const Point3d& point, const Triangle3d& triangle) {
  return stages::closest_point_on_triangle::ask(point, triangle).answer;
}

}  // namespace touchstone::robust
