// SPDX-License-Identifier: Apache-2.0
#include "oracle/planes/point_ground_plane.h"

#include "oracle/exact/rational_validation.h"
#include "oracle/exact/space.h"

namespace touchstone::oracle {
namespace {

const Plane<Rational> ground{{0, 1, 0}, 0};

template <class Number>
Rational height(const Point3<Number>& point) {
  validation::validate("point", point);
  return height_over(ground, exact(point));
}

Truth<Height> truth(const Rational& e) {
  return {sgn(e) > 0 ? Height::above : sgn(e) < 0 ? Height::below : Height::on, Rational(abs(e))};
}

}  // namespace

Truth<Height> point_ground_plane(const Point3d& point) { return truth(height(point)); }

template <Exact Number>
Truth<Height> point_ground_plane(const Point3<Number>& point) {
  return truth(height(point));
}
template Truth<Height> point_ground_plane(const Point3<Rational>&);

Certificate point_ground_plane_certificate(const Point3d& point) { return {"height", {{"height", {height(point)}}}}; }

}  // namespace touchstone::oracle
