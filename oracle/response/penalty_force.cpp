// SPDX-License-Identifier: Apache-2.0
#include "oracle/response/penalty_force.h"

#include <utility>

#include "oracle/exact/numbers/normal_frame.h"
#include "oracle/exact/numbers/space.h"
#include "oracle/exact/systems/impact.h"

namespace touchstone::oracle {
namespace {

struct Situation {
  Rational height, squared_normal;
  Vector3<Rational> foot, along;  ///< of the point on the plane; of the velocity
};

template <class Number>
Situation examine(const Point3<Number>& point, const Vector3<Number>& velocity, const Plane<Number>& plane,
                  const Number& stiffness, const Number& damping) {
  validation::validate_all("point", point, "velocity", velocity, "plane", plane, "stiffness", stiffness, "damping",
                           damping);
  const Vector3<Number>& n = plane.normal;
  const CommonScale<Number, 3> places({point.x, point.y, point.z}), normals({n.x, n.y, n.z});
  const NormalFrame frame(integer_vector(normals, 0));
  const Rational unit(normals.actual(Rational(1), 1) * places.actual(Rational(1), 1));
  const Plane<Rational> exactly = exact(plane);
  return {height_over(exactly, exact(point)), dot(exactly.normal, exactly.normal),
          actual_vector(places, frame.with_product(Rational(-exactly.offset / unit), integer_vector(places, 0))),
          exact_vector(velocity) - after_bounce(velocity, n, Rational(0))};
}

}  // namespace

template <Exact Number>
Truth<Vector3<Rational>> penalty_force(const Point3<Number>& point, const Vector3<Number>& velocity,
                                       const Plane<Number>& plane, const Number& stiffness, const Number& damping) {
  Situation s = examine(point, velocity, plane, stiffness, damping);
  const Rational margin(s.height * s.height / s.squared_normal);
  if (sgn(s.height) >= 0)
    return {{Rational(0), Rational(0), Rational(0)}, margin, [] { return Certificate{"no_contact", {}}; }};
  Vector3<Rational> force = exact(stiffness) * (s.foot - from_origin(point)) - exact(damping) * s.along;
  return {std::move(force), margin, [foot = std::move(s.foot), along = std::move(s.along)] {
            return Certificate{"foot", {{"foot", listed(foot)}, {"along", listed(along)}}};
          }};
}
template Truth<Vector3<Rational>> penalty_force(const Point3d&, const Vector3d&, const Plane3d&, const double&,
                                                const double&);
template Truth<Vector3<Rational>> penalty_force(const Point3<Rational>&, const Vector3<Rational>&,
                                                const Plane<Rational>&, const Rational&, const Rational&);

}  // namespace touchstone::oracle
