// SPDX-License-Identifier: Apache-2.0
#include "oracle/volumes/closest_point_on_obb.h"

#include "oracle/exact/shapes/round_solid.h"

namespace touchstone::oracle {
namespace {

template <class Number>
Truth<ClosestPoint3<Surd>> truth_of_closest_point_on_obb(const Point3<Number>& point, const Obb3<Number>& obb) {
  validation::validate_numbers("point", point), validation::validate_numbers("obb", obb);
  validate_parallelepiped("obb", obb);
  const NearestPair nearest = any_nearest_pair(round_solid(obb).core, {exact(point)});
  return truth_of_distance(ClosestPoint3<Surd>{in_space(nearest.on_a), {}, {}}, nearest.squared_distance,
                           {{"coefficients", coefficients_of(nearest.weights_of_a)}});
}

}  // namespace

Truth<ClosestPoint3<Surd>> closest_point_on_obb(const Point3d& point, const Obb3d& obb) {
  return truth_of_closest_point_on_obb(point, obb);
}

template <Exact Number>
Truth<ClosestPoint3<Surd>> closest_point_on_obb(const Point3<Number>& point, const Obb3<Number>& obb) {
  return truth_of_closest_point_on_obb(point, obb);
}
template Truth<ClosestPoint3<Surd>> closest_point_on_obb(const Point3<Rational>&, const Obb3<Rational>&);

}  // namespace touchstone::oracle
