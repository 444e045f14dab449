// SPDX-License-Identifier: Apache-2.0
#include "oracle/planes/point_plane.h"

#include "geometry/validation.h"
#include "oracle/exact/numbers/space.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<PointPlane<Surd>> point_plane(const Plane<Number>& plane, const Point3<Number>& point) {
  validation::validate_all("plane", plane, "point", point);
  const Plane<Rational> exactly = exact(plane);
  const Rational height = height_over(exactly, exact(point));
  const Rational square(height * height / dot(exactly.normal, exactly.normal));
  const int sign = sgn(height);
  const PlaneSide side = sign > 0 ? PlaneSide::front : sign < 0 ? PlaneSide::back : PlaneSide::on;
  const Surd distance(0, sign, square);
  const char* const kind = distance.rational() ? "root" : "irrational_root";
  return {{side, distance}, square, [kind] { return Certificate{kind, {}}; }};
}
template Truth<PointPlane<Surd>> point_plane(const Plane3d&, const Point3d&);
template Truth<PointPlane<Surd>> point_plane(const Plane<Rational>&, const Point3<Rational>&);

}  // namespace touchstone::oracle
