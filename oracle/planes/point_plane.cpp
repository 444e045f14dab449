// SPDX-License-Identifier: Apache-2.0
#include "oracle/planes/point_plane.h"

#include "oracle/exact/rational_validation.h"
#include "oracle/exact/space.h"
#include "oracle/exact/square_root.h"

namespace touchstone::oracle {
namespace {

struct Situation {
  Rational height, squared_normal;
  Rational squared_distance() const { return Rational(height * height / squared_normal); }
  Enclosed distance() const { return signed_root(squared_distance(), sgn(height)); }
};

template <class Number>
Situation examine(const Plane<Number>& plane, const Point3<Number>& point) {
  validation::validate("plane", plane), validation::validate("point", point);
  const Plane<Rational> exactly = exact(plane);
  return {height_over(exactly, exact(point)), dot(exactly.normal, exactly.normal)};
}

Truth<PointPlane<Rational>> truth(const Situation& s) {
  const int sign = sgn(s.height);
  const PlaneSide side = sign > 0 ? PlaneSide::front : sign < 0 ? PlaneSide::back : PlaneSide::on;
  return {{side, s.distance().value}, s.squared_distance()};
}

}  // namespace

Truth<PointPlane<Rational>> point_plane(const Plane3d& plane, const Point3d& point) {
  return truth(examine(plane, point));
}

template <Exact Number>
Truth<PointPlane<Rational>> point_plane(const Plane<Number>& plane, const Point3<Number>& point) {
  return truth(examine(plane, point));
}
template Truth<PointPlane<Rational>> point_plane(const Plane<Rational>&, const Point3<Rational>&);

Certificate point_plane_certificate(const Plane3d& plane, const Point3d& point) {
  const Enclosed distance = examine(plane, point).distance();
  if (distance.rational()) return {"root", {}};
  return {"enclosure", {{"distance", {distance.low, distance.high}}}};
}

}  // namespace touchstone::oracle
