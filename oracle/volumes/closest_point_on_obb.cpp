// SPDX-License-Identifier: Apache-2.0
#include "oracle/volumes/closest_point_on_obb.h"

#include "oracle/exact/shapes/round_solid.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<ClosestPoint3<Surd>> closest_point_on_obb(const Point3<Number>& point, const Obb3<Number>& obb) {
  validation::validate_numbers("point", point), validation::validate_numbers("obb", obb);
  validate_parallelepiped("obb", obb);
  const NearestPair nearest = any_nearest_pair(round_solid(obb).core, {exact(point)});
  return truth_of_distance(ClosestPoint3<Surd>{in_space(nearest.on_a), {}, {}}, nearest.squared_distance,
                           {{"coefficients", coefficients_of(nearest.weights_of_a)}});
}
template Truth<ClosestPoint3<Surd>> closest_point_on_obb(const Point3d&, const Obb3d&);
template Truth<ClosestPoint3<Surd>> closest_point_on_obb(const Point3<Rational>&, const Obb3<Rational>&);

}  // namespace touchstone::oracle
