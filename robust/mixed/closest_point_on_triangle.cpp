// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/closest_point_on_triangle.h"

#include "robust/kernel/nearest_points.h"
#include "robust/kernel/valid_capsules.h"

namespace touchstone::robust {

ClosestPoint3<double> closest_point_on_triangle(const Point3d& point, const Triangle3d& triangle) {
  const auto& [a, b, c] = triangle;
  if (!kernel::valid(point) || !kernel::valid(triangle))
    validation::validate_numbers("point", point), validation::validate_numbers("triangle", triangle);
  const auto [at, exponent] = kernel::whole_points(point, a, b, c);
  return kernel::closest_point(at[0], kernel::nearest_on_triangle(at[0], {at[1], at[2], at[3]}), exponent);
}

}  // namespace touchstone::robust
