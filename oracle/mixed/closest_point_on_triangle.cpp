// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/closest_point_on_triangle.h"

#include "geometry/validation.h"
#include "oracle/exact/shapes/nearest_pair.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<ClosestPoint3<Surd>> closest_point_on_triangle(const Point3<Number>& point, const Triangle3<Number>& triangle) {
  validation::validate_numbers("point", point), validation::validate_numbers("triangle", triangle);
  const NearestPair nearest = nearest_pair({exact(triangle.a), exact(triangle.b), exact(triangle.c)}, {exact(point)});
  return truth_of_distance(ClosestPoint3<Surd>{in_space(nearest.on_a), {}, {}}, nearest.squared_distance,
                           {{"weights", nearest.weights_of_a}});
}
template Truth<ClosestPoint3<Surd>> closest_point_on_triangle(const Point3d&, const Triangle3d&);
template Truth<ClosestPoint3<Surd>> closest_point_on_triangle(const Point3<Rational>&, const Triangle3<Rational>&);

}  // namespace touchstone::oracle
