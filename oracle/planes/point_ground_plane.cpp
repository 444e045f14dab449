// SPDX-License-Identifier: Apache-2.0
#include "oracle/planes/point_ground_plane.h"

#include "geometry/validation.h"
#include "oracle/exact/numbers/space.h"

namespace touchstone::oracle {
namespace {

const Plane<Rational> ground{{0, 1, 0}, 0};

}  // namespace

template <Exact Number>
Truth<Height> point_ground_plane(const Point3<Number>& point) {
  validation::validate("point", point);
  const Rational e = height_over(ground, exact(point));
  return {sgn(e) > 0   ? Height::above
          : sgn(e) < 0 ? Height::below
                       : Height::on,
          Rational(abs(e)), [e] {
            return Certificate{"height", {{"height", {e}}}};
          }};
}
template Truth<Height> point_ground_plane(const Point3d&);
template Truth<Height> point_ground_plane(const Point3<Rational>&);

}  // namespace touchstone::oracle
