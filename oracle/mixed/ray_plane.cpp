// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/ray_plane.h"

#include <algorithm>

#include "geometry/validation.h"
#include "oracle/exact/numbers/space.h"
#include "oracle/exact/shapes/line_plane.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<LinePlane<Rational>> ray_plane(const Ray3<Number>& ray, const Plane<Number>& plane) {
  validation::validate_all("ray", ray, "plane", plane);
  const auto& [x, y, z] = ray.direction;
  const Point3<Rational> origin = exact(ray.origin);
  const LinePlaneHeights heights(origin, origin + Vector3<Rational>{exact(x), exact(y), exact(z)}, exact(plane));
  const Rational rise(heights.at_end() - heights.at_start());
  return {heights.common(false), std::min(heights.squared_distance(heights.at_start()), heights.squared_distance(rise)),
          [=] { return heights.certificate(); }};
}
template Truth<LinePlane<Rational>> ray_plane(const Ray3d&, const Plane3d&);
template Truth<LinePlane<Rational>> ray_plane(const Ray3<Rational>&, const Plane<Rational>&);

}  // namespace touchstone::oracle
